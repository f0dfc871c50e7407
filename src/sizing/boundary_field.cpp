#include "sizing/boundary_field.hpp"

#include "sizing/background_mesh.hpp"
#include "sizing/tet_linear.hpp"
#include "sizing/tree_search.hpp"

namespace unsliver::sizing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Distances and values are trusted to this share of the coordinates and values in play.
constexpr double kSlack = 1e-8;
/// Height over longest edge below which rounding may spoil a gradient.
constexpr double kTrustedFlatness = 1e-6;

std::vector<Box3> boxes_of(const TriangleMesh& surface) {
  std::vector<Box3> boxes;
  for (const auto& [a, b, c] : surface.triangles)
    boxes.push_back(geom::bounding_box({surface.points[a], surface.points[b], surface.points[c]}));
  return boxes;
}

}  // namespace

BoundaryField::BoundaryField(const TriangleMesh& surface, const std::vector<double>& values)
    : nearest_(surface), is_convex_(sizing::is_convex(surface)), boxes_(boxes_of(surface)) {
  std::vector<double> least;
  for (const auto& [a, b, c] : surface.triangles) {
    const geom::Triangle corners{surface.points[a], surface.points[b], surface.points[c]};
    const std::array<double, 3> at_corners{values[a], values[b], values[c]};
    facets_.push_back({corners, at_corners, slope_of(corners, at_corners)});
    least.push_back(facets_.back().least());
  }
  node_least_ = node_minima(boxes_, least);
}

double BoundaryField::at(const Vec3& p) const {
  const auto nearest = nearest_.nearest(p, kInfinity);
  return facets_[nearest.triangle].at(nearest.point);
}

/// The nearest point q(p) of a point p within r of the centre c lies on a triangle T within d + 2 r of c, d
/// being the distance of c. The point of a convex set nearest to p moves no faster than p does, so q(p) is
/// within r of the point of T nearest to c. Where the whole surface is convex, q(p) is within r of q(c), and
/// only triangles there count.
double BoundaryField::lower_bound(const Box3& box) const {
  const auto nearest = nearest_.nearest(box.center(), kInfinity);
  const double slack = kSlack * (norm(box.center()) + nearest.distance + box.diagonal());
  const double r = 0.5 * box.diagonal() + slack;
  const Vec3 from = is_convex_ ? nearest.point : box.center();
  const double reach = is_convex_ ? r : nearest.distance + 2 * r;
  const auto node = [&](std::uint32_t n) {
    return geom::dist_sq(from, boxes_.nodes()[n].box) <= reach * reach ? node_least_[n] : kInfinity;
  };
  const auto item = [&](std::uint32_t t) {
    const Vec3 q = geom::closest_point(facets_[t].corners, from);
    if (norm(q - from) > reach) return kInfinity;
    return std::max(facets_[t].least(), facets_[t].at(q) - facets_[t].slope * r);
  };
  return least_item(boxes_, kInfinity, node, item).value * (1 - kSlack);
}

/// Weights cut to [0, 1] keep the result between the corner values.
double BoundaryField::Facet::at(const Vec3& p) const {
  const auto weights = triangle_coordinates(corners, p);
  return std::clamp(weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2], least(),
                    std::max({values[0], values[1], values[2]}));
}

/// The gradient is in the plane, so that it is fixed by the values along two edges.
double BoundaryField::slope_of(const geom::Triangle& corners, const std::array<double, 3>& values) {
  const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0];
  const Vec3 normal = cross(u, v);
  const double longest_sq = std::max({norm_sq(u), norm_sq(v), norm_sq(v - u)});
  if (!(norm(normal) > kTrustedFlatness * longest_sq)) return kInfinity;
  const Vec3 turned = (values[1] - values[0]) * v - (values[2] - values[0]) * u;
  return norm(turned) / norm(normal) * (1 + 1e-6);
}

}  // namespace unsliver::sizing
