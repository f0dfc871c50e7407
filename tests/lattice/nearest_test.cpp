#include <gtest/gtest.h>

#include <optional>

#include "lattice/level.hpp"
#include "reference.hpp"

namespace unsliver::lattice {
namespace {

using reference::Point;
using reference::Random;
__extension__ using Int128 = __int128;

constexpr std::int64_t kGrid = 8;  ///< query points are multiples of 1/8

Int128 dist_sq(const Point& eighths, const Point& q) {
  const Int128 x = eighths.x - kGrid * q.x, y = eighths.y - kGrid * q.y, z = eighths.z - kGrid * q.z;
  return x * x + y * y + z * z;
}

/// The nearest of all lattice points in a cube of four cells a side, the first of equals.
Point nearest_by_scan(Level level, const Point& eighths) {
  const std::int64_t step = std::int64_t{1} << (level % 2 == 0 ? level / 2 - 1 : level / 2);
  const std::int64_t reach = level % 2 == 0 ? 4 : 2;
  const auto around = [&](std::int64_t c) { return (c / (kGrid * step) / 2 * 2) * step; };
  const Point base{around(eighths.x), around(eighths.y), around(eighths.z)};
  std::optional<Point> best;
  for (std::int64_t i = -reach; i <= reach; ++i) {
    for (std::int64_t j = -reach; j <= reach; ++j) {
      for (std::int64_t k = -reach; k <= reach; ++k) {
        const Point q{base.x + i * step, base.y + j * step, base.z + k * step};
        if (!reference::on_lattice(level, q)) continue;
        if (!best || dist_sq(eighths, q) < dist_sq(eighths, *best)) best = q;
      }
    }
  }
  return *best;
}

Vec3 from_eighths(const Point& p) { return (1.0 / kGrid) * reference::to_vec(p); }

TEST(Nearest, IsTheFirstOfTheNearestByScan) {
  Random random(11);
  for (int i = 0; i < 60'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, 93));
    // Points on a coarse grid relative to the lattice: ties are frequent.
    const std::int64_t eighth = std::int64_t{1} << std::max(0, level / 2 - 1 - int(random.integer(0, 3)));
    const std::int64_t bound = std::min<std::int64_t>(200, (std::int64_t{1} << 49) / eighth);
    Point p = random.point(bound);
    p = {p.x * eighth, p.y * eighth, p.z * eighth};
    EXPECT_EQ(nearest(level, from_eighths(p)), reference::to_vec(nearest_by_scan(level, p)))
        << "level " << level << " p " << from_eighths(p);
  }
}

TEST(Nearest, KeepsItsPromisesAtFinePointsFarOut) {
  Random random(12);
  for (int i = 0; i < 60'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, kMaxLevel));
    const Point p = random.point(std::int64_t{1} << random.integer(1, 50));
    EXPECT_EQ(nearest(level, from_eighths(p)), reference::to_vec(nearest_by_scan(level, p)))
        << "level " << level << " p " << from_eighths(p);
  }
}

TEST(Nearest, RealPointsAreCovered) {
  Random random(13);
  for (int i = 0; i < 100'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, 80));
    const double reach = random.real(0, 30) * power_of_two(level / 2);
    const Vec3 p{random.real(-reach, reach), random.real(-reach, reach), random.real(-reach, reach)};
    const Vec3 q = nearest(level, p);
    EXPECT_TRUE(reference::on_lattice(level, reference::to_point(q))) << q;
    EXPECT_LE(dist(p, q), covering_radius(level) * (1 + 1e-14)) << "level " << level << " p " << p;
  }
}

TEST(Nearest, LatticePointsAreTheirOwn) {
  Random random(14);
  for (int i = 0; i < 50'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, kMaxLevel));
    const Vec3 p = reference::to_vec(random.lattice_point(level));
    EXPECT_EQ(nearest(level, p), p) << "level " << level;
  }
}

TEST(Nearest, RoundsWithoutDoubleRoundingAndWithoutMinusZero) {
  const double almost_half = 0.49999999999999994;
  for (const double sign : {1.0, -1.0}) {
    const Vec3 q = nearest(1, {sign * almost_half, sign * 1e-300, sign * 0.0});
    EXPECT_EQ(q, (Vec3{0, 0, 0}));
    EXPECT_FALSE(std::signbit(q.x) || std::signbit(q.y) || std::signbit(q.z));
  }
  EXPECT_EQ(nearest(1, {-0.5, 0.5, -1.5}), (Vec3{-1, 0, -2}));
}

}  // namespace
}  // namespace unsliver::lattice
