#include "lattice/ball.hpp"

#include <cmath>

namespace unsliver::lattice {
namespace {

constexpr double sq(double a) { return a * a; }

constexpr double kSlack = 1e-9;

/// The smallest start + i * stride that is >= bound.
double first_from(double bound, double start, double stride) {
  return start + stride * std::ceil((bound - start) / stride);
}

/// The indices along one axis with |index - center| <= reach that agree with `start` modulo the stride.
struct Row {
  Row(double center, double reach_sq, double start, double stride) {
    const double reach = std::sqrt(std::max(reach_sq, 0.0));
    first = first_from(center - reach, start, stride);
    last = center + reach;
  }
  double first, last;
};

}  // namespace

// Indices count multiples of 2^k' from `base`, a nearby lattice point with even multiples, so that no digit
// of the center is lost far from the origin. In BCC the y and z indices have the parity of the x index.
void points_in_ball(Level level, const Vec3& center, double radius, std::vector<Vec3>& out) {
  if (!(radius >= 0)) return;
  const double unit = power_of_two(region_exponent(level));
  const double stride = is_bcc(level) ? 2 : 1;
  const Vec3 base = nearest(2 * exponent(level) + 1, center);
  const Vec3 c = (1.0 / unit) * (center - base);
  const double reach_sq = sq(radius / unit * (1 + kSlack));

  const Row xs(c.x, reach_sq, 0, 1);
  for (double i = xs.first; i <= xs.last; ++i) {
    const double reach_y_sq = reach_sq - sq(i - c.x);
    const Row ys(c.y, reach_y_sq, i, stride);
    for (double j = ys.first; j <= ys.last; j += stride) {
      const Row zs(c.z, reach_y_sq - sq(j - c.y), i, stride);
      for (double k = zs.first; k <= zs.last; k += stride) out.push_back(base + unit * Vec3{i, j, k});
    }
  }
}

}  // namespace unsliver::lattice
