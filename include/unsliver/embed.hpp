/// \file
/// A detailed surface that rides on a coarse mesh: each of its vertices in a tetrahedron, by barycentric
/// coordinates. Where the mesh's vertices move, the surface's move along.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "unsliver/mesh.hpp"

namespace unsliver {

/// One entry a point p: p = sum of weights[i] * mesh.points[vertices[i]], but for rounding.
struct Embedding {
  std::vector<std::int64_t> tets;                     ///< in the mesh; the first of those that serve equally
  std::vector<std::array<std::int64_t, 4>> vertices;  ///< corners of that tetrahedron, in its order
  std::vector<std::array<double, 4>> weights;         ///< >= 0, their sum is 1 but for rounding
};

/// Takes as long as sorting the tetrahedra. Points may lie outside by the rounding of coordinates, as they do
/// where a mesh ends at the surface.
/// Requires finite points and valid indices. Tetrahedra without volume serve nobody.
/// \throws Error kBadInput, with ids and places, where some points lie in no tetrahedron.
Embedding embed_points(const TetMesh& mesh, std::span<const Vec3> points);

}  // namespace unsliver
