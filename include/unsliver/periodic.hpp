/// \file
/// Meshes of periodic cells: Labelle's first reading of his algorithms, in which there is no boundary, and
/// every tetrahedron has the angles that are promised.
#pragma once

#include <span>

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

/// The label of triangles beyond which lies a copy of the mesh moved by (i, j, k) periods, each in -1 .. 1
/// and not all of them 0: 1 to 27. The triangle's partner is labelled 28 less that.
constexpr int periodic_face_label(int i, int j, int k) { return 14 + i + 3 * j + 9 * k; }

}  // namespace unsliver
