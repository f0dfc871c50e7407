#include "geom/triangle_orient.hpp"

#include <gtest/gtest.h>

#include "domain/sample_surfaces.hpp"

namespace unsliver::geom {
namespace {

using samples::Dice;

/// Points on a plane with exact coordinates, moved off it by one unit in the last place.
TEST(TriangleOrient, SeesOneUnitInTheLastPlace) {
  const Vec3 a{1, 1, 1}, b{3, 1, 2}, c{1, 5, 4};
  const Vec3 d = a + 0.5 * (b - a) + 0.25 * (c - a);
  EXPECT_EQ(exact_orient3d(a, b, c, d), 0);
  Vec3 above = d, below = d;
  above.z = std::nextafter(d.z, 100.0);
  below.z = std::nextafter(d.z, -100.0);
  EXPECT_EQ(exact_orient3d(a, b, c, above), 1);
  EXPECT_EQ(exact_orient3d(a, b, c, below), -1);
}

/// The grid of points around (0.5, 0.5): plain doubles get many of these wrong, even in sign symmetry.
TEST(TriangleOrient, NearlyCollinearPointsAreAntisymmetricAndTransitive) {
  int zeros = 0;
  for (int i = 0; i < 32; ++i)
    for (int j = 0; j < 32; ++j) {
      const Vec3 p{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53, 0}, q{12, 12, 0}, r{24, 24, 0};
      const int side = exact_orient2d(p, q, r, 0, 1);
      EXPECT_EQ(side, (j > i) - (j < i)) << i << " " << j;
      EXPECT_EQ(side, -exact_orient2d(q, p, r, 0, 1));
      EXPECT_EQ(side, exact_orient2d(q, r, p, 0, 1));
      zeros += side == 0;
    }
  EXPECT_EQ(zeros, 32);
}

TEST(TriangleOrient, MatchesIntegersAndPermutations) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto small = [&] { return static_cast<double>(dice.below(7)) - 3; };
    for (int n = 0; n < 500; ++n) {
      std::array<Vec3, 4> p;
      for (Vec3& q : p) q = {small(), small(), small()};
      const double det = dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0]));
      const int sign = (det > 0) - (det < 0);
      const double scale = n % 2 ? 0x1p-40 : 0x1p60;
      for (Vec3& q : p) q = scale * q;
      EXPECT_EQ(exact_orient3d(p[0], p[1], p[2], p[3]), sign);
      EXPECT_EQ(exact_orient3d(p[1], p[0], p[2], p[3]), -sign);
      EXPECT_EQ(exact_orient3d(p[1], p[2], p[0], p[3]), sign);
      EXPECT_EQ(exact_orient3d(p[3], p[1], p[2], p[0]), -sign);
    }
  }
}

/// Points on the plane x + y + z = 0.1 up to rounding: their sign may be any, but one.
TEST(TriangleOrient, RoundedPlanesGiveOneSignInAnyOrder) {
  Dice dice(7);
  int decided = 0;
  for (int n = 0; n < 2000; ++n) {
    std::array<Vec3, 4> p;
    for (Vec3& q : p) {
      q.x = dice.in(-1, 1);
      q.y = dice.in(-1, 1);
      q.z = 0.1 - q.x - q.y;
    }
    const int sign = exact_orient3d(p[0], p[1], p[2], p[3]);
    decided += sign != 0;
    EXPECT_EQ(exact_orient3d(p[2], p[3], p[0], p[1]), sign);
    EXPECT_EQ(exact_orient3d(p[3], p[2], p[0], p[1]), -sign);
    EXPECT_EQ(exact_orient3d(p[1], p[3], p[2], p[0]), sign);
  }
  EXPECT_GT(decided, 1000);
}

}  // namespace
}  // namespace unsliver::geom
