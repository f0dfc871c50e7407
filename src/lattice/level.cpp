#include "lattice/level.hpp"

#include <cmath>

namespace unsliver::lattice {
namespace {

__extension__ using Uint128 = unsigned __int128;

/// Is c in [1/2, 1) the double nearest to sqrt(sixteenths / 16)? With n = 2^53 c an integer, that is
/// (n - 1/2)^2 < 2^106 sixteenths / 16 < (n + 1/2)^2.
constexpr bool is_nearest_root(double c, unsigned sixteenths) {
  const auto n = Uint128(c * 0x1p53);
  const Uint128 square = Uint128(sixteenths) << 104;
  return (2 * n - 1) * (2 * n - 1) < square && square < (2 * n + 1) * (2 * n + 1);
}
static_assert(is_nearest_root(kHalfSqrt3, 12));
static_assert(is_nearest_root(kQuarterSqrt5, 5));

constexpr bool covering_radii_increase() {
  for (Level level = kMinLevel; level < kMaxLevel; ++level) {
    if (covering_radius(level) >= covering_radius(level + 1)) return false;
  }
  return true;
}
static_assert(covering_radii_increase());
// In [2^k, 2^{k+1}) only these three levels can be the answer of coarsest_within.
static_assert(kHalfSqrt3 <= 1 && 4 * kQuarterSqrt5 >= 2);

/// The integer nearest to t, the smaller one of two. (t + 1/2 would round; floor(t) + 1/2 does not.)
double round_half_down(double t) {
  const double below = std::floor(t);
  return below + (t > below + 0.5 ? 1.0 : 0.0);
}

Vec3 nearest_cube_corner(double side, const Vec3& p) {
  const double per_side = 1.0 / side;
  return {side * round_half_down(per_side * p.x), side * round_half_down(per_side * p.y),
          side * round_half_down(per_side * p.z)};
}

}  // namespace

Level coarsest_within(double radius) {
  if (!(radius >= covering_radius(kMinLevel))) return kMinLevel - 1;
  if (radius >= covering_radius(kMaxLevel)) return kMaxLevel;
  const int k = int(std::bit_cast<std::uint64_t>(radius) >> 52) - 1023;
  const Level sc = 2 * k + 1;
  return sc + (radius >= covering_radius(sc + 1)) + (radius >= covering_radius(sc + 2));
}

// BCC: let a be the nearest cube corner and h half a side. The nearest cell centre is a + (+-h, +-h, +-h)
// with the signs of d = p - a, and |d|^2 - |d - (+-h, +-h, +-h)|^2 = 2h (|dx| + |dy| + |dz| - 3h/2). The
// differences are exact: a coordinate of a is 0 or within a factor 2 of that of p.
Vec3 nearest(Level level, const Vec3& p) {
  const double side = power_of_two(exponent(level));
  const Vec3 corner = nearest_cube_corner(side, p);
  if (!is_bcc(level)) return corner;
  const double h = 0.5 * side;
  const Vec3 d = p - corner;
  const double sum = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
  const Vec3 center = corner + Vec3{d.x > 0 ? h : -h, d.y > 0 ? h : -h, d.z > 0 ? h : -h};
  if (sum == 1.5 * h) return lex_less(center, corner) ? center : corner;
  return sum > 1.5 * h ? center : corner;
}

}  // namespace unsliver::lattice
