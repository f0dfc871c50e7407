#include "lattice/input_sites.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "geom/point_tree.hpp"
#include "unsliver/error.hpp"

namespace unsliver::lattice {
namespace {

std::string describe(std::span<const Vec3> points, VertexId id) {
  const Vec3& p = points[id];
  return fmt::format("{} at ({}, {}, {})", id, p.x, p.y, p.z);
}

[[noreturn]] void refuse(ErrorCode code, std::span<const Vec3> points, std::vector<VertexId> ids,
                         std::string message) {
  Error error(code, std::move(message));
  error.ids.assign(ids.begin(), ids.end());
  for (const VertexId id : ids) error.places.push_back(points[id]);
  throw error;
}

void require_usable(std::span<const Vec3> points) {
  if (points.size() >= kNoVertex)
    throw Error(ErrorCode::kLimit, fmt::format("{} points are more than a mesh can number.", points.size()));
  for (VertexId id = 0; id < points.size(); ++id)
    if (!is_finite(points[id]))
      refuse(ErrorCode::kBadInput, points, {id},
             fmt::format("Point {}: coordinates must be finite numbers.", describe(points, id)));
}

/// Sorted by coordinates, equal points by id.
std::vector<VertexId> sorted_ids(std::span<const Vec3> points) {
  std::vector<VertexId> ids(points.size());
  std::iota(ids.begin(), ids.end(), VertexId{0});
  std::sort(ids.begin(), ids.end(), [&](VertexId a, VertexId b) {
    return points[a] == points[b] ? a < b : lex_less(points[a], points[b]);
  });
  return ids;
}

InputSites merge_equal(std::span<const Vec3> points) {
  std::vector<VertexId> first_equal(points.size());  // of each point, the first that equals it
  VertexId first = 0;
  for (const VertexId id : sorted_ids(points)) {
    if (!(points[id] == points[first])) first = id;
    first_equal[id] = first;
  }
  InputSites sites;
  sites.site_of.resize(points.size());
  for (VertexId id = 0; id < points.size(); ++id) {
    const bool is_first = first_equal[id] == id;
    sites.site_of[id] = is_first ? VertexId(sites.first_point.size()) : sites.site_of[first_equal[id]];
    if (is_first) sites.first_point.push_back(id);
  }
  return sites;
}

/// The sites scaled by a power of two, such that squares of their distances neither overflow nor (where that
/// matters) underflow. Distances are exact but for the rounding of differences.
class ScaledSites {
 public:
  ScaledSites(const InputSites& sites, std::span<const Vec3> points, double extent) {
    double largest = extent;
    for (const Vec3& p : points)
      largest =
          std::max({largest, 0x1p-500 * std::abs(p.x), 0x1p-500 * std::abs(p.y), 0x1p-500 * std::abs(p.z)});
    exponent_ = largest > 0 ? std::ilogb(largest) : 0;
    for (const VertexId id : sites.first_point)
      places_.push_back({scaled(points[id].x), scaled(points[id].y), scaled(points[id].z)});
  }
  const std::vector<Vec3>& places() const { return places_; }
  double scaled(double length) const { return std::ldexp(length, -exponent_); }
  double unscaled(double length) const { return std::ldexp(length, exponent_); }

 private:
  int exponent_ = 0;
  std::vector<Vec3> places_;
};

struct ClosestPair {
  VertexId first = 0, second = 0;  ///< sites
  double distance_sq = std::numeric_limits<double>::infinity();
};

VertexId neighbour_at(const geom::PointTree& tree, const Vec3& place, VertexId site, double distance_sq) {
  VertexId found = kNoVertex;
  const double half = std::max(std::sqrt(distance_sq) * (1 + 0x1p-50), 0x1p-500);  // squares below are 0
  tree.visit_cube(place, half, [&](VertexId other, const Vec3& q) {
    if (other != site && dist_sq(q, place) == distance_sq) found = std::min(found, other);
    return false;
  });
  return found;
}

/// The first of the closest pairs, by the order of sites.
ClosestPair closest_pair(const geom::PointTree& tree, const std::vector<Vec3>& places) {
  ClosestPair best;
  for (VertexId site = 0; site < places.size(); ++site) {
    const double d = tree.two_nearest(places[site], best.distance_sq).second_sq;
    if (d < best.distance_sq) best = {site, 0, d};
  }
  if (std::isfinite(best.distance_sq))
    best.second = neighbour_at(tree, places[best.first], best.first, best.distance_sq);
  return best;
}

/// Sites with another one nearer than the scaled distance.
std::size_t count_crowded(const geom::PointTree& tree, const std::vector<Vec3>& places, double distance) {
  return std::size_t(std::count_if(places.begin(), places.end(), [&](const Vec3& place) {
    return tree.two_nearest(place, distance * distance).second_sq < distance * distance;
  }));
}

}  // namespace

std::vector<std::vector<VertexId>> InputSites::merged_groups() const {
  std::vector<std::vector<VertexId>> members(first_point.size());
  for (VertexId id = 0; id < site_of.size(); ++id) members[site_of[id]].push_back(id);
  std::erase_if(members, [](const auto& group) { return group.size() < 2; });
  return members;
}

std::string InputSites::note() const {
  if (duplicate_count() == 0) return {};
  VertexId id = 0;
  while (first_point[site_of[id]] == id) ++id;
  return fmt::format(
      "{} of {} points repeat an earlier one (the first is point {}, which equals point {}); "
      "equal points become one vertex.",
      duplicate_count(), site_of.size(), id, first_point[site_of[id]]);
}

InputSites find_sites(std::span<const Vec3> points, double extent) {
  require_usable(points);
  InputSites sites = merge_equal(points);
  const ScaledSites scaled(sites, points, extent);
  const geom::PointTree tree(scaled.places());
  const ClosestPair pair = closest_pair(tree, scaled.places());
  sites.closest = scaled.unscaled(std::sqrt(pair.distance_sq));
  const double least = kLeastSeparation * extent;
  if (sites.closest >= least) return sites;
  const VertexId a = sites.first_point[pair.first], b = sites.first_point[pair.second];
  refuse(ErrorCode::kBadInput, points, {a, b},
         fmt::format("Points {} and {} are {:.6g} apart, but different points have to be at least {:.6g} "
                     "apart: {:g} of the domain's extent, which is {:.6g}. There are {} points with a "
                     "neighbour too close. Make such points equal (round the coordinates), or leave out "
                     "all but one.",
                     describe(points, a), describe(points, b), sites.closest, least, kLeastSeparation, extent,
                     count_crowded(tree, scaled.places(), scaled.scaled(least))));
}

std::vector<Vec3> to_world(const InputSites& sites, std::span<const Vec3> points, const World& world) {
  // Points more than 2 units apart differ by more than 1 along some axis, and rounding takes away at most 1.
  if (!(sites.closest > 2 * world.unit()))
    throw Error(ErrorCode::kBadInput,
                fmt::format("The closest points are {:.6g} apart, too close for a world of unit {:.6g}.",
                            sites.closest, world.unit()));
  std::vector<Vec3> places;
  places.reserve(sites.first_point.size());
  for (const VertexId id : sites.first_point) {
    const Vec3 q = world.to_world(points[id]);
    if (!(std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z)}) < 0x1p48))
      refuse(ErrorCode::kBadInput, points, {id},
             fmt::format("Point {} lies too far outside the domain.", describe(points, id)));
    places.push_back(q);
  }
  return places;
}

}  // namespace unsliver::lattice
