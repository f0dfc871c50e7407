#include "sizing/background_mesh.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace unsliver::sizing {
namespace {

constexpr double kFlat = 1e-10;  // sine of the largest inward bend that rounding of coordinates excuses

using Corners = std::array<VertexId, 3>;

/// An edge of a triangle: its ends in increasing order, and where it comes from.
struct Edge {
  std::array<VertexId, 2> ends;
  std::uint32_t triangle;
  VertexId opposite;
};

std::vector<Edge> sorted_edges(const TriangleMesh& surface) {
  std::vector<Edge> edges;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const Corners& v = surface.triangles[t];
    for (int i = 0; i < 3; ++i) {
      const VertexId a = v[i], b = v[(i + 1) % 3];
      edges.push_back({{std::min(a, b), std::max(a, b)}, t, v[(i + 2) % 3]});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.ends != b.ends ? a.ends < b.ends : a.triangle < b.triangle;
  });
  return edges;
}

bool bends_inwards(const TriangleMesh& surface, const Edge& edge, const Edge& other) {
  const Corners& v = surface.triangles[edge.triangle];
  const Vec3& a = surface.points[v[0]];
  const Vec3 normal = cross(surface.points[v[1]] - a, surface.points[v[2]] - a);
  const Vec3 across = surface.points[other.opposite] - a;
  return dot(normal, across) > kFlat * norm(normal) * norm(across);
}

class Components {
 public:
  explicit Components(std::size_t n) : parent_(n), count_(n) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    --count_;
  }
  std::size_t count() const { return count_; }

 private:
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  std::vector<std::uint32_t> parent_;
  std::size_t count_;
};

}  // namespace

bool is_convex(const TriangleMesh& boundary) {
  const std::vector<Edge> edges = sorted_edges(boundary);
  Components components(boundary.triangles.size());
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const bool is_pair = i + 1 < edges.size() && edges[i].ends == edges[i + 1].ends;
    const bool is_shared = i + 2 < edges.size() && edges[i].ends == edges[i + 2].ends;
    if (!is_pair || is_shared || bends_inwards(boundary, edges[i], edges[i + 1])) return false;
    components.join(edges[i].triangle, edges[i + 1].triangle);
  }
  return components.count() == 1;
}

}  // namespace unsliver::sizing
