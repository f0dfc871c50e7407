#include "domain/surface_orientation.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "domain/surface_topology.hpp"

namespace unsliver::domain {
namespace {

using Corners = std::array<VertexId, 3>;

/// The edge {a, b}, a < b, of one triangle.
struct HalfEdge {
  VertexId a = 0, b = 0;
  std::uint32_t triangle = 0;
  bool forward = true;  ///< the triangle runs from a to b
};

/// The triangle across an edge, and whether it must be turned if this one is not.
struct Neighbour {
  std::uint32_t triangle = 0;
  bool opposed = false;
};

using Neighbours = std::vector<std::array<std::optional<Neighbour>, 3>>;

std::vector<HalfEdge> half_edges(const std::vector<Corners>& triangles) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (has_equal_corners(triangles[t])) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), t, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& s, const HalfEdge& t) {
    return std::tie(s.a, s.b, s.triangle) < std::tie(t.a, t.b, t.triangle);
  });
  return edges;
}

/// Across edges of exactly two triangles.
Neighbours neighbours(const std::vector<Corners>& triangles) {
  Neighbours result(triangles.size());
  const auto link = [&](std::uint32_t from, std::uint32_t to, bool opposed) {
    for (auto& slot : result[from]) {
      if (slot) continue;
      slot = {to, opposed};
      return;
    }
  };
  const std::vector<HalfEdge> edges = half_edges(triangles);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].a == edges[i].a && edges[end].b == edges[i].b) ++end;
    if (end == i + 2) {
      const HalfEdge &s = edges[i], &t = edges[i + 1];
      link(s.triangle, t.triangle, s.forward == t.forward);
      link(t.triangle, s.triangle, s.forward == t.forward);
    }
    i = end;
  }
  return result;
}

struct Patch {
  std::vector<std::uint32_t> triangles;
  bool agrees = true;      ///< no two triangles are opposed
  bool orientable = true;  ///< turning some makes them agree
};

/// All triangles joined to `first`; sets which of them to turn. Unvisited triangles have no entry in
/// `turned`.
Patch walk_patch(std::uint32_t first, const Neighbours& across, std::vector<std::optional<bool>>& turned) {
  Patch patch;
  patch.triangles.push_back(first);
  turned[first] = false;
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    const std::uint32_t t = patch.triangles[i];
    for (const auto& next : across[t]) {
      if (!next) continue;
      const bool turn = *turned[t] != next->opposed;
      patch.agrees = patch.agrees && !next->opposed;
      if (!turned[next->triangle]) {
        turned[next->triangle] = turn;
        patch.triangles.push_back(next->triangle);
      } else if (*turned[next->triangle] != turn) {
        patch.orientable = false;
      }
    }
  }
  return patch;
}

}  // namespace

std::size_t turn_to_agree(const std::vector<Vec3>& points, std::vector<Corners>& triangles) {
  const Neighbours across = neighbours(triangles);
  Box3 box;
  for (const Corners& v : triangles)
    for (const VertexId i : v) box.extend(points[i]);
  const Vec3 middle = box.center();
  const auto volume = [&](const Corners& v) {
    return dot(points[v[0]] - middle, cross(points[v[1]] - middle, points[v[2]] - middle));
  };
  std::vector<std::optional<bool>> turned(triangles.size());
  std::size_t count = 0;
  for (std::uint32_t first = 0; first < triangles.size(); ++first) {
    if (turned[first]) continue;
    const Patch patch = walk_patch(first, across, turned);
    if (patch.agrees || !patch.orientable) continue;
    double sum = 0;
    for (const std::uint32_t t : patch.triangles)
      sum += *turned[t] ? -volume(triangles[t]) : volume(triangles[t]);
    for (const std::uint32_t t : patch.triangles) {
      if (*turned[t] == (sum < 0)) continue;
      std::swap(triangles[t][1], triangles[t][2]);
      ++count;
    }
  }
  return count;
}

}  // namespace unsliver::domain
