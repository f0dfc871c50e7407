#include "union_of_tets.hpp"

#include <array>

namespace unsliver::cli {
namespace {

using Triangle = std::array<VertexId, 3>;

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

TriangleMesh boundary_surface(const TetMesh& mesh) { return compact(mesh.points, boundary_facets(mesh)); }

}  // namespace unsliver::cli
