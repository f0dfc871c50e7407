/// \file
/// What hangs together with what in a triangle surface: equal points, directed edges, components.
#pragma once

#include <vector>

#include "unsliver/mesh.hpp"

namespace unsliver::domain {

/// For each point, the smallest id of a point at the same coordinates.
std::vector<VertexId> merge_equal_points(const std::vector<Vec3>& points);

/// The triangles on merged points; those with two equal corners stay in place.
std::vector<std::array<VertexId, 3>> merged_triangles(const TriangleMesh& surface,
                                                      const std::vector<VertexId>& merged);

inline bool has_equal_corners(const std::array<VertexId, 3>& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// All triangles at one edge {a, b}, a < b.
struct EdgeUse {
  VertexId a = 0, b = 0;
  std::uint32_t forward = 0, backward = 0;  ///< triangles that run from a to b, from b to a
};

/// In order of (a, b). Triangles with equal corners do not count: their edges cancel.
std::vector<EdgeUse> edge_uses(const std::vector<std::array<VertexId, 3>>& triangles);

/// For each triangle the number of its component, from 0: triangles that share a point are in one.
struct Components {
  std::vector<std::uint32_t> of;
  std::size_t count = 0;
};
Components components(const std::vector<std::array<VertexId, 3>>& triangles, std::size_t point_count);

}  // namespace unsliver::domain
