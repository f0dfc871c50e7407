#include "sizing/periodic.hpp"

#include <cmath>
#include <numbers>

#include "geom/triangle_bvh.hpp"

namespace unsliver::sizing {
namespace {

/// How many periods x is beyond the cell, or before it.
double periods_away(double x, double lo, double period) { return std::floor((x - lo) / period); }

Box3 clamped(const Box3& box, const Box3& cell) {
  Box3 result;
  for (int axis = 0; axis < 3; ++axis) {
    result.lo[axis] = std::clamp(box.lo[axis], cell.lo[axis], cell.hi[axis]);
    result.hi[axis] = std::clamp(box.hi[axis], cell.lo[axis], cell.hi[axis]);
  }
  return result;
}

/// The distance between two boxes.
double gap(const Box3& a, const Box3& b) {
  Vec3 d;
  for (int axis = 0; axis < 3; ++axis)
    d[axis] = std::max({0.0, a.lo[axis] - b.hi[axis], b.lo[axis] - a.hi[axis]});
  return norm(d);
}

/// Calls visit(box + T) for T = 0 and the vectors to the 26 neighbouring cells.
template <class Visit>
void for_each_copy(const Box3& box, const Vec3& period, const Visit& visit) {
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k) {
        const Vec3 shift{i * period.x, j * period.y, k * period.z};
        visit(Box3{box.lo + shift, box.hi + shift});
      }
}

}  // namespace

Periodic::Periodic(const Sizing& s, const Box3& cell)
    : s_(s),
      cell_(cell),
      slope_(std::isfinite(s.lipschitz()) ? s.lipschitz() : 0),
      least_(s.lower_bound(cell)) {}

double Periodic::lipschitz() const { return std::numbers::sqrt2 * s_.lipschitz(); }

double Periodic::at(const Vec3& p) const { return least_over({p, p}); }

double Periodic::lower_bound(const Box3& box) const { return least_over(box); }

/// The least of what is known of s over the copies of the query that meet the cell, and of the cones over
/// others. Points are boxes whose bound is the value itself.
double Periodic::least_over(const Box3& query) const {
  const Vec3 period = cell_.size();
  Box3 home = query;
  for (int axis = 0; axis < 3; ++axis) {
    const double away = periods_away(query.lo[axis], cell_.lo[axis], period[axis]);
    home.lo[axis] -= away * period[axis];
    home.hi[axis] -= away * period[axis];
    if (home.hi[axis] - home.lo[axis] >= period[axis])
      home.lo[axis] = cell_.lo[axis], home.hi[axis] = cell_.hi[axis];
  }
  const bool is_point = home.lo == home.hi;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const Box3& copy) {
    const double rise = slope_ * gap(copy, cell_);
    if (least_ + rise >= least) return;
    const Box3 part = clamped(copy, cell_);
    least = std::min(least, (is_point ? s_.at(part.lo) : s_.lower_bound(part)) + rise);
  };
  consider(home);
  for_each_copy(home, period, [&](const Box3& copy) {
    if (slope_ > 0 || gap(copy, cell_) == 0) consider(copy);
  });
  return least;
}

}  // namespace unsliver::sizing
