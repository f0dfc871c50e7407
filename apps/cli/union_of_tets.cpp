#include "union_of_tets.hpp"

#include <algorithm>
#include <array>

namespace unsliver::cli {
namespace {

using Triangle = std::array<VertexId, 3>;

struct Facet {
  Triangle sorted;
  Triangle outward;
};

bool is_inverted(const Tet& t) { return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) < 0; }

std::array<Triangle, 4> outward_facets(const TetMesh& mesh, std::size_t t) {
  auto [a, b, c, d] = mesh.tets[t];
  if (is_inverted(mesh.corners(t))) std::swap(c, d);
  return {{{b, c, d}, {a, d, c}, {a, b, d}, {a, c, b}}};
}

/// All facets, equal ones side by side.
std::vector<Facet> sorted_facets(const TetMesh& mesh) {
  std::vector<Facet> facets;
  facets.reserve(4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Triangle& outward : outward_facets(mesh, t)) {
      Triangle sorted = outward;
      std::sort(sorted.begin(), sorted.end());
      facets.push_back({sorted, outward});
    }
  std::sort(facets.begin(), facets.end(), [](const Facet& f, const Facet& g) { return f.sorted < g.sorted; });
  return facets;
}

template <typename Simplices>
std::vector<VertexId> ids_in(const Simplices& simplices, std::size_t point_count) {
  std::vector<bool> used(point_count, false);
  for (const auto& simplex : simplices)
    for (const VertexId v : simplex) used[v] = true;
  std::vector<VertexId> ids;
  for (VertexId v = 0; v < point_count; ++v)
    if (used[v]) ids.push_back(v);
  return ids;
}

/// Leaves out the points that no triangle uses.
TriangleMesh compact(const std::vector<Vec3>& points, std::vector<Triangle> triangles) {
  TriangleMesh surface;
  std::vector<VertexId> place(points.size(), kNoVertex);
  for (const VertexId v : ids_in(triangles, points.size())) {
    place[v] = static_cast<VertexId>(surface.points.size());
    surface.points.push_back(points[v]);
  }
  for (Triangle& triangle : triangles)
    for (VertexId& v : triangle) v = place[v];
  surface.triangles = std::move(triangles);
  return surface;
}

}  // namespace

std::vector<VertexId> used_vertices(const TetMesh& mesh) { return ids_in(mesh.tets, mesh.points.size()); }

TriangleMesh boundary_surface(const TetMesh& mesh) {
  const std::vector<Facet> facets = sorted_facets(mesh);
  std::vector<Triangle> boundary;
  for (auto f = facets.begin(); f != facets.end();) {
    const auto next = std::find_if(f, facets.end(), [&](const Facet& g) { return g.sorted != f->sorted; });
    if (next - f == 1) boundary.push_back(f->outward);
    f = next;
  }
  return compact(mesh.points, std::move(boundary));
}

}  // namespace unsliver::cli
