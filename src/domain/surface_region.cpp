#include "domain/surface_region.hpp"

#include "domain/tet_box.hpp"

namespace unsliver::domain {
namespace {

/// Twice the error of TriangleTree::winding_number: once here, once where `holds` was asked.
constexpr double kWindingError = 2e-3;

double radius_about(const Vec3& p, const Tet& t) {
  double radius_sq = 0;
  for (const Vec3& corner : t) radius_sq = std::max(radius_sq, dist_sq(p, corner));
  return (1 + 1e-12) * std::sqrt(radius_sq);
}

/// Both halves of t, cut at the middle of its longest edge.
std::array<Tet, 2> halves(const Tet& t) {
  int i = 0, j = 1;
  for (int a = 0; a < 4; ++a)
    for (int b = a + 1; b < 4; ++b)
      if (dist_sq(t[a], t[b]) > dist_sq(t[i], t[j])) i = a, j = b;
  const Vec3 middle = t[i] + 0.5 * (t[j] - t[i]);
  std::array<Tet, 2> parts{t, t};
  parts[0][i] = middle;
  parts[1][j] = middle;
  return parts;
}

}  // namespace

Side SurfaceRegion::side_around(const Vec3& p, double radius) const {
  const double excess = tree_.winding_number(p) - 0.5;
  const double change = radius * rim_.gradient_bound(p, radius);
  if (!(std::abs(excess) > change + kWindingError)) return Side::kUnknown;
  return excess > 0 ? Side::kInside : Side::kOutside;
}

double SurfaceRegion::clearance(const Vec3& p, double radius) const {
  const double excess = tree_.winding_number(p) - 0.5;
  radius *= 0.5;
  radius = std::min(radius, (std::abs(excess) - kWindingError) / rim_.gradient_bound(p, radius));
  if (!(radius > 0)) return 0;
  return excess > 0 ? -radius : radius;
}

bool SurfaceRegion::may_hold_part_of(const Tet& t, int splits_left) const {
  const Vec3 center = centroid(t);
  switch (side_around(center, radius_about(center, t))) {
    case Side::kInside:
      return true;
    case Side::kOutside:
      return false;
    case Side::kUnknown:
      break;
  }
  if (splits_left == 0 || holds(center)) return true;
  for (const Tet& half : halves(t))
    if (may_hold_part_of(half, splits_left - 1)) return true;
  return false;
}

}  // namespace unsliver::domain
