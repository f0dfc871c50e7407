/// \file
/// Meshes of periodic cells: Labelle's first reading of his algorithms, in which there is no boundary, and
/// every tetrahedron has the angles that are promised.
#pragma once

#include <span>
#include <vector>

#include "unsliver/refine.hpp"

namespace unsliver {

/// A mesh of the torus that a box becomes when its opposite faces are one.
///
/// Ensures (status kDone): what mesh_domain ensures, for all tetrahedra without exception; every vertex once
/// (mesh.periodicity tells the points that are copies); tetrahedra, facets and edges are told by their
/// vertices, and no empty ball has a diameter of half the shortest side or more, so sizes beyond a quarter of
/// it count as that. The facets between a tetrahedron of the mesh and a copy of another are mesh.triangles,
/// outward, in pairs: see periodic_face_label.
///
/// Input vertices may lie anywhere: each is moved by whole periods into the cell, coordinates that lie in it
/// bit for bit, and those that meet there are one. s is asked at points of the cell; where it would jump
/// across faces it is lowered to its own Lipschitz constant, and repeated as it is where it has none.
///
/// A problem shifted by a vector of the coarsest lattice (cubes that stack up to the box) gives the same
/// mesh, shifted, if there are input vertices.
///
/// \throws Error as mesh_domain does, and kUnsupported or kLimit as mesh_box does for boxes that no equal
/// cubes of a side m * 2^e fill: with a box near it that will do in the message.
MeshResult mesh_periodic(const Box3& cell, const Sizing& sizing, std::span<const Vec3> inputs = {},
                         const MeshOptions& options = {}, const Control& control = {});

/// The points, each moved by whole periods into the half-open cell if it is not there already. Moving rounds:
/// a point that was moved and meets another one but for rounding becomes equal to it.
/// \throws Error kUnsupported or kLimit as above.
std::vector<Vec3> points_in_cell(const Box3& cell, std::span<const Vec3> points);

}  // namespace unsliver
