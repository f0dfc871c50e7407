#include <fmt/format.h>

#include "domain/ranges.hpp"
#include "domain/surface_topology.hpp"
#include "geom/triangle_bvh.hpp"
#include "geom/triangle_shape.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/error.hpp"

namespace unsliver {
namespace {

using domain::EdgeUse;
using geom::Triangle;
using Corners = std::array<VertexId, 3>;

constexpr std::size_t kMostExamples = 10;
constexpr std::size_t kMostSelfIntersections = 10000;

void record(Defect& defect, std::vector<std::int64_t> ids) {
  if (defect.count++ < kMostExamples) defect.first.push_back(std::move(ids));
}

void require_valid(const TriangleMesh& surface) {
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    if (is_finite(surface.points[i])) continue;
    Error error(ErrorCode::kBadInput,
                fmt::format("point {} of {} has a coordinate that is not a finite number: {}", i,
                            surface.name.empty() ? "the surface" : surface.name,
                            domain::format_point(surface.points[i])));
    error.ids = {static_cast<std::int64_t>(i)};
    throw error;
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (const VertexId v : surface.triangles[t]) {
      if (v < surface.points.size()) continue;
      Error error(ErrorCode::kBadInput,
                  fmt::format("triangle {} of {} refers to point {}, but there are {} points", t,
                              surface.name.empty() ? "the surface" : surface.name, v, surface.points.size()));
      error.ids = {static_cast<std::int64_t>(t)};
      throw error;
    }
  }
}

void count_duplicate_points(const std::vector<VertexId>& merged, SurfaceDefects& defects) {
  for (std::size_t v = 0; v < merged.size(); ++v)
    if (merged[v] != v) record(defects.duplicate_points, {static_cast<std::int64_t>(v)});
}

void count_bad_triangles(const TriangleMesh& surface, const std::vector<Corners>& triangles,
                         SurfaceDefects& defects) {
  std::vector<std::pair<Corners, std::int64_t>> sorted;
  sorted.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Corners v = triangles[t];
    const Vec3 area = geom::area_vector({surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]});
    if (norm_sq(area) == 0) record(defects.degenerate_triangles, {static_cast<std::int64_t>(t)});
    std::sort(v.begin(), v.end());
    if (!domain::has_equal_corners(v)) sorted.emplace_back(v, static_cast<std::int64_t>(t));
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

/// Finds pairs of triangles that cross, each triangle against the later ones.
class CrossingSearch {
 public:
  CrossingSearch(const TriangleMesh& surface, const std::vector<Corners>& corners) {
    for (std::size_t t = 0; t < corners.size(); ++t) {
      const Corners& v = corners[t];
      const Triangle triangle{surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]};
      if (norm_sq(geom::area_vector(triangle)) == 0) continue;
      ids_.push_back(static_cast<std::int64_t>(t));
      corners_.push_back(v);
      triangles_.push_back(triangle);
      boxes_.push_back(geom::bounding_box(triangle));
    }
  }

  /// False if the search stopped early.
  bool run(Defect& found) const {
    const geom::BoxTree tree(boxes_);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      tree.walk([&](const geom::BoxTree::Node& node) { return node.box.overlaps(boxes_[t]); },
                [&](std::uint32_t first, std::uint32_t count) {
                  for (std::uint32_t i = first; i < first + count; ++i)
                    if (tree.order()[i] > t && cross(t, tree.order()[i]))
                      record(found, {ids_[t], ids_[tree.order()[i]]});
                  return false;
                });
      if (found.count >= kMostSelfIntersections) return false;
    }
    return true;
  }

 private:
  bool cross(std::size_t s, std::size_t t) const {
    if (!boxes_[s].overlaps(boxes_[t])) return false;
    Triangle a = triangles_[s], b = triangles_[t];
    Corners of_a = corners_[s], of_b = corners_[t];
    int shared = 0;
    for (int i = 0; i < 3; ++i) {
      const auto same = std::find(of_b.begin() + shared, of_b.end(), of_a[i]);
      if (same == of_b.end()) continue;
      const auto j = same - of_b.begin();
      std::swap(of_a[shared], of_a[i]);
      std::swap(a[shared], a[i]);
      std::swap(of_b[shared], of_b[j]);
      std::swap(b[shared], b[j]);
      ++shared;
    }
    return shared < 3 && geom::triangles_cross(a, b, shared);
  }

  std::vector<std::int64_t> ids_;
  std::vector<Corners> corners_;
  std::vector<Triangle> triangles_;
  std::vector<Box3> boxes_;
};

}  // namespace

SurfaceDefects inspect_surface(const TriangleMesh& surface) {
  require_valid(surface);
  SurfaceDefects defects;
  defects.points = surface.points.size();
  defects.triangles = surface.triangles.size();
  const std::vector<VertexId> merged = domain::merge_equal_points(surface.points);
  const std::vector<Corners> triangles = domain::merged_triangles(surface, merged);
  count_duplicate_points(merged, defects);
  count_bad_triangles(surface, triangles, defects);
  count_bad_edges(domain::edge_uses(triangles), defects);
  measure_components(surface, triangles, defects);
  defects.self_intersections_complete = CrossingSearch(surface, triangles).run(defects.self_intersections);
  return defects;
}

}  // namespace unsliver
