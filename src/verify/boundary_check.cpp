#include "verify/boundary_check.hpp"

#include <algorithm>

namespace unsliver::verifier {
namespace {

/// An edge of a boundary facet, walked from low to high or back.
struct DirectedEdge {
  VertexId low, high;
  int direction;

  friend bool operator<(const DirectedEdge& a, const DirectedEdge& b) {
    return a.low != b.low ? a.low < b.low : a.high < b.high;
  }
};

std::vector<DirectedEdge> edges_of(const std::vector<Facet>& facets) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * facets.size());
  for (const auto& f : facets) {
    for (int i = 0; i < 3; ++i) {
      const VertexId a = f[i], b = f[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::size_t count_vertices(const std::vector<Facet>& facets, std::size_t point_count) {
  std::vector<bool> seen(point_count, false);
  for (const auto& f : facets) {
    for (const VertexId v : f) seen[v] = true;
  }
  return static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
}

}  // namespace

void check_boundary(const Context& c, const std::vector<Facet>& facets) {
  const auto edges = edges_of(facets);
  std::size_t edge_count = 0, pinched = 0;
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    int balance = 0;
    for (; end < edges.size() && !(edges[i] < edges[end]); ++end) balance += edges[end].direction;
    ++edge_count;
    pinched += end - i > 2;
    if (balance == 0) continue;
    const VertexId a = edges[i].low, b = edges[i].high;
    c.reporter.find("boundary", {a, b}, [&] {
      return "the boundary is not closed at edge " + std::to_string(a) + " " + std::to_string(b) + " from " +
             full(c.mesh.points[a]) + " to " + full(c.mesh.points[b]);
    });
  }
  const bool closed = c.reporter.count("boundary") == 0;
  const auto euler = static_cast<std::int64_t>(count_vertices(facets, c.mesh.points.size()) + facets.size()) -
                     static_cast<std::int64_t>(edge_count);
  c.reporter.line("boundary: " + grouped(facets.size()) + " facets, " + (closed ? "closed" : "NOT closed") +
                  ", " +
                  (pinched == 0 ? "edge-manifold" : grouped(pinched) + " edges in more than two facets") +
                  ", Euler characteristic " + std::to_string(euler));
}

}  // namespace unsliver::verifier
