/// \file
/// From vertices at home and tetrahedra of the torus to a mesh of the cell, with copies where it reaches
/// beyond.
#pragma once

#include <array>
#include <vector>

#include "delaunay/space.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::refine {

/// The copy of a vertex.
struct PeriodicCorner {
  VertexId home;
  delaunay::Torus::Shift shift;

  bool is_home() const { return (shift.x | shift.y | shift.z) == 0; }
};
using PeriodicCorners = std::array<PeriodicCorner, 4>;

/// `homes` has all but tetrahedra, triangles and periodicity; corners refer to its points. Tetrahedra stay in
/// their order, moved by whole periods: each to where its least corner along each axis is in the cell, but
/// for a few that vertices need so as not to be corners as copies alone. Copies come behind the homes, in
/// order of use. Triangles: see mesh_periodic.
TetMesh assemble_periodic(TetMesh homes, const Box3& cell, std::vector<PeriodicCorners> tets);

}  // namespace unsliver::refine
