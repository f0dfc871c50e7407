#include "domain/surface_topology.hpp"

#include <algorithm>
#include <numeric>

namespace unsliver::domain {

std::vector<VertexId> merge_equal_points(const std::vector<Vec3>& points) {
  std::vector<VertexId> order(points.size()), merged(points.size());
  std::iota(order.begin(), order.end(), VertexId{0});
  std::sort(order.begin(), order.end(), [&](VertexId i, VertexId j) {
    return points[i] == points[j] ? i < j : lex_less(points[i], points[j]);
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    merged[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? merged[order[i - 1]] : order[i];
  return merged;
}

std::vector<std::array<VertexId, 3>> merged_triangles(const TriangleMesh& surface,
                                                      const std::vector<VertexId>& merged) {
  std::vector<std::array<VertexId, 3>> triangles;
  triangles.reserve(surface.triangles.size());
  for (const auto& t : surface.triangles) triangles.push_back({merged[t[0]], merged[t[1]], merged[t[2]]});
  return triangles;
}

std::vector<EdgeUse> edge_uses(const std::vector<std::array<VertexId, 3>>& triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (const auto& t : triangles) {
    if (has_equal_corners(t)) continue;
    for (int i = 0; i < 3; ++i) {
      const VertexId from = t[i], to = t[(i + 1) % 3];
      uses.push_back(from < to ? EdgeUse{from, to, 1, 0} : EdgeUse{to, from, 0, 1});
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const EdgeUse& s, const EdgeUse& t) { return s.a != t.a ? s.a < t.a : s.b < t.b; });
  std::size_t kept = 0;
  for (const EdgeUse& use : uses) {
    if (kept > 0 && uses[kept - 1].a == use.a && uses[kept - 1].b == use.b) {
      uses[kept - 1].forward += use.forward;
      uses[kept - 1].backward += use.backward;
    } else {
      uses[kept++] = use;
    }
  }
  uses.resize(kept);
  return uses;
}

Components components(const std::vector<std::array<VertexId, 3>>& triangles, std::size_t point_count) {
  std::vector<VertexId> parent(point_count);
  std::iota(parent.begin(), parent.end(), VertexId{0});
  const auto root = [&](VertexId v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& t : triangles)
    for (int i = 1; i < 3; ++i) parent[root(t[i])] = root(t[0]);
  Components result;
  std::vector<std::uint32_t> number(point_count, kNoVertex);
  result.of.reserve(triangles.size());
  for (const auto& t : triangles) {
    std::uint32_t& component = number[root(t[0])];
    if (component == kNoVertex) component = static_cast<std::uint32_t>(result.count++);
    result.of.push_back(component);
  }
  return result;
}

}  // namespace unsliver::domain
