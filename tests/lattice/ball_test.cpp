#include "lattice/ball.hpp"

#include <gtest/gtest.h>

#include "reference.hpp"

namespace unsliver::lattice {
namespace {

using reference::Point;
using reference::Random;

constexpr double kSlack = 1e-9;

std::vector<Vec3> ball(Level level, const Vec3& center, double radius) {
  std::vector<Vec3> points;
  points_in_ball(level, center, radius, points);
  return points;
}

/// Distances from `center` are exact enough: differences are, and squares lose 1e-16.
std::vector<Vec3> ball_by_scan(Level level, const Vec3& center, double radius) {
  const std::int64_t step = std::int64_t{1} << (level % 2 == 0 ? level / 2 - 1 : level / 2);
  const auto reach = std::int64_t(radius / double(step)) + 2;
  const auto around = [&](double c) { return std::int64_t(std::floor(c / double(step))) * step; };
  const Point base{around(center.x), around(center.y), around(center.z)};
  std::vector<Vec3> points;
  for (std::int64_t i = -reach; i <= reach; ++i) {
    for (std::int64_t j = -reach; j <= reach; ++j) {
      for (std::int64_t k = -reach; k <= reach; ++k) {
        const Point q{base.x + i * step, base.y + j * step, base.z + k * step};
        const Vec3 v = reference::to_vec(q);
        if (dist(v, center) <= radius * (1 + kSlack / 2) && reference::on_lattice(level, q)) {
          points.push_back(v);
        }
      }
    }
  }
  return points;
}

TEST(Ball, IsTheScanInLexicographicOrder) {
  Random random(21);
  for (int i = 0; i < 3'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, 84));
    const double unit = power_of_two(level / 2);
    const double reach = unit * random.real(0, 40);
    const Vec3 center{random.real(-reach, reach), random.real(-reach, reach), random.real(-reach, reach)};
    const double radius = unit * random.real(0, 4);
    EXPECT_EQ(ball(level, center, radius), ball_by_scan(level, center, radius))
        << "level " << level << " center " << center << " radius " << radius;
  }
}

TEST(Ball, HoldsThePointsOnItsSphere) {
  Random random(22);
  for (int i = 0; i < 3'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, 84));
    const double unit = power_of_two(level / 2);
    const Point c = random.point(64);
    const Vec3 center = unit / 8 * reference::to_vec(c);
    const double radius = unit / 8 * std::sqrt(double(random.integer(0, 900)));
    EXPECT_EQ(ball(level, center, radius), ball_by_scan(level, center, radius))
        << "level " << level << " center " << center << " radius " << radius;
  }
}

TEST(Ball, LosesNoDigitFarOut) {
  Random random(23);
  for (int i = 0; i < 3'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, 5));
    const double far = 0x1p47;
    const Vec3 center = {far - random.real(0, 64), -far + random.real(0, 64), far - random.real(0, 64)};
    const double radius = random.real(0, 6);
    EXPECT_EQ(ball(level, center, radius), ball_by_scan(level, center, radius))
        << "level " << level << " center " << center << " radius " << radius;
  }
}

TEST(Ball, OfCoveringRadiusIsNeverEmpty) {
  Random random(24);
  for (int i = 0; i < 20'000; ++i) {
    const Level level = Level(random.integer(kMinLevel, 84));
    const double reach = 9 * power_of_two(level / 2);
    const Vec3 center{random.real(-reach, reach), random.real(-reach, reach), random.real(-reach, reach)};
    EXPECT_FALSE(ball(level, center, covering_radius(level)).empty()) << "level " << level << " " << center;
  }
  // The deepest holes (Proposition 4): the four or eight points around, and none below the radius.
  EXPECT_EQ(ball(7, {-4, 4, 12}, covering_radius(7)).size(), 8U);
  EXPECT_EQ(ball(6, {-4, -2, 0}, covering_radius(6)).size(), 4U);
  EXPECT_TRUE(ball(7, {-4, 4, 12}, 0.999 * covering_radius(7)).empty());
  EXPECT_TRUE(ball(6, {-4, -2, 0}, 0.999 * covering_radius(6)).empty());
}

TEST(Ball, SmallRadii) {
  EXPECT_EQ(ball(3, {-2, 4, 6}, 0), std::vector<Vec3>({{-2, 4, 6}}));
  EXPECT_EQ(ball(3, {-2, 4, 6}, 1e-300), std::vector<Vec3>({{-2, 4, 6}}));
  EXPECT_TRUE(ball(3, {-2, 4, 6.5}, 0).empty());
  EXPECT_TRUE(ball(3, {-2, 4, 6}, -1).empty());
  EXPECT_TRUE(ball(3, {-2, 4, 6}, std::nan("")).empty());
}

TEST(Ball, Appends) {
  std::vector<Vec3> points = {{7, 7, 7}};
  points_in_ball(1, {0, 0, 0}, 1, points);
  ASSERT_EQ(points.size(), 8U);
  EXPECT_EQ(points[0], (Vec3{7, 7, 7}));
  EXPECT_EQ(points[1], (Vec3{-1, 0, 0}));
  EXPECT_EQ(points[7], (Vec3{1, 0, 0}));
}

}  // namespace
}  // namespace unsliver::lattice
