#include "domain/ranges.hpp"
#include "domain/surface_crossings.hpp"
#include "domain/surface_topology.hpp"
#include "geom/triangle_shape.hpp"
#include "unsliver/domain.hpp"

namespace unsliver {
namespace {

using domain::EdgeUse;
using Corners = std::array<VertexId, 3>;

constexpr std::size_t kMostExamples = 10;
constexpr std::size_t kMostSelfIntersections = 10000;

std::int64_t as_id(std::size_t i) { return static_cast<std::int64_t>(i); }

void record(Defect& defect, std::vector<std::int64_t> ids) {
  if (defect.count++ < kMostExamples) defect.first.push_back(std::move(ids));
}

void count_duplicate_points(const std::vector<VertexId>& merged, SurfaceDefects& defects) {
  for (std::size_t v = 0; v < merged.size(); ++v)
    if (merged[v] != v) record(defects.duplicate_points, {as_id(v)});
}

void count_bad_triangles(const TriangleMesh& surface, const std::vector<Corners>& triangles,
                         SurfaceDefects& defects) {
  std::vector<std::pair<Corners, std::int64_t>> sorted;
  sorted.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Corners v = triangles[t];
    const Vec3 area = geom::area_vector({surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]});
    if (norm_sq(area) == 0) record(defects.degenerate_triangles, {as_id(t)});
    std::sort(v.begin(), v.end());
    if (!domain::has_equal_corners(v)) sorted.emplace_back(v, as_id(t));
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first)
      record(defects.duplicate_triangles, {sorted[i - 1].second, sorted[i].second});
}

void count_bad_edges(const std::vector<EdgeUse>& uses, SurfaceDefects& defects) {
  for (const EdgeUse& use : uses) {
    const std::uint32_t all = use.forward + use.backward;
    if (all == 1) record(defects.boundary_edges, {use.a, use.b});
    if (all > 2) record(defects.non_manifold_edges, {use.a, use.b});
    if (all == 2 && use.forward != use.backward) record(defects.inconsistent_edges, {use.a, use.b});
  }
}

void measure_components(const TriangleMesh& surface, const std::vector<Corners>& triangles,
                        SurfaceDefects& defects) {
  const domain::Components parts = domain::components(triangles, surface.points.size());
  std::vector<double> volume(parts.count, 0.0);
  Box3 box;
  for (const Corners& v : triangles)
    for (const VertexId i : v) box.extend(surface.points[i]);
  const Vec3 origin = box.center();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Corners& v = triangles[t];
    const Vec3 a = surface.points[v[0]] - origin, b = surface.points[v[1]] - origin,
               c = surface.points[v[2]] - origin;
    volume[parts.of[t]] += dot(a, cross(b, c)) / 6;
  }
  defects.components = parts.count;
  for (const double part : volume) {
    defects.signed_volume += part;
    if (part < 0) ++defects.inward_components;
  }
}

}  // namespace

SurfaceDefects inspect_surface(const TriangleMesh& surface) {
  domain::require_valid_surface(surface);
  SurfaceDefects defects;
  defects.points = surface.points.size();
  defects.triangles = surface.triangles.size();
  const std::vector<VertexId> merged = domain::merge_equal_points(surface.points);
  const std::vector<Corners> triangles = domain::merged_triangles(surface, merged);
  count_duplicate_points(merged, defects);
  count_bad_triangles(surface, triangles, defects);
  count_bad_edges(domain::edge_uses(triangles), defects);
  measure_components(surface, triangles, defects);
  defects.self_intersections_complete = domain::find_crossings(
      surface.points, triangles, kMostSelfIntersections, [&](std::size_t s, std::size_t t) {
        record(defects.self_intersections, {as_id(s), as_id(t)});
      });
  return defects;
}

}  // namespace unsliver
