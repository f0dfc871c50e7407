#include <gtest/gtest.h>

#include <random>

#include "unsliver/domain.hpp"

namespace unsliver {
namespace {

double unit(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

Vec3 point_in(const Box3& box, std::mt19937_64& random) {
  return {box.lo.x + unit(random) * box.size().x, box.lo.y + unit(random) * box.size().y,
          box.lo.z + unit(random) * box.size().z};
}

/// Where a side is claimed, every sampled point of the open ball is on it; and the claim is made wherever
/// `clearance` allows it.
void expect_sound(const Domain& domain, std::uint64_t seed, bool exact = true) {
  std::mt19937_64 random(seed);
  Box3 box = domain.bounds();
  const Vec3 margin = 0.2 * box.size();
  box = {box.lo - margin, box.hi + margin};
  int claims = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vec3 p = point_in(box, random);
    const double radius = 0.3 * unit(random) * unit(random) * box.longest_side();
    const int side = domain.side_of_ball(p, radius);
    const double clearance = domain.clearance(p);
    if (exact && std::abs(clearance) > radius * (1 + 1e-9)) {
      EXPECT_EQ(side, clearance > 0 ? 1 : -1) << "seed " << seed << ", trial " << trial;
    }
    if (side == 0) continue;
    ++claims;
    for (int sample = 0; sample < 20; ++sample) {
      const Vec3 q = point_in({p - Vec3{radius, radius, radius}, p + Vec3{radius, radius, radius}}, random);
      if (dist(p, q) < radius * (1 - 1e-9)) {
        EXPECT_EQ(domain.contains(q), side < 0) << "seed " << seed << ", trial " << trial;
      }
    }
  }
  EXPECT_GT(claims, 100);
}

TEST(SideOfBall, IsSoundForEveryKindOfDomain) {
  expect_sound(*make_ball({0.1, 0.2, 0.3}, 1), 1);
  expect_sound(*make_box({{-1, 0, 2}, {1, 0.5, 3}}), 2);
  expect_sound(*make_implicit("x^2 + 2*y^2 + z^4 - 1", {{-1.2, -1, -1.2}, {1.2, 1, 1.2}}), 3, false);
  const TriangleMesh tetrahedron{{{0, 0, 0}, {2, 0, 0.1}, {0.3, 1.7, 0}, {0.2, 0.3, 1.5}},
                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}},
                                 "tetrahedron"};
  expect_sound(*make_surface(tetrahedron), 4);
}

/// A claim is never wrong, and for small tetrahedra at most a hundredth of the ball's radius away it is made.
TEST(PlainlyOutside, IsSoundAndSharpForABall) {
  const Vec3 center{0.1, 0.2, 0.3};
  const double radius = 0.7;
  const DomainPtr ball = make_ball(center, radius);
  std::mt19937_64 random(5);
  int claims = 0, near_claims = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const Vec3 p = point_in({center - Vec3{1, 1, 1}, center + Vec3{1, 1, 1}}, random);
    const double size = 0.5 * unit(random) * unit(random);
    Tet t;
    for (Vec3& corner : t)
      corner = point_in({p - Vec3{size, size, size}, p + Vec3{size, size, size}}, random);
    const double gap = dist(p, center) - radius;
    if (gap > 0.01 && size < 0.5 * gap * gap) {
      EXPECT_TRUE(ball->plainly_outside(t)) << "trial " << trial;
      ++near_claims;
    }
    if (!ball->plainly_outside(t)) continue;
    ++claims;
    EXPECT_FALSE(ball->meets(t)) << "trial " << trial;
  }
  EXPECT_GT(claims, 500);
  EXPECT_GT(near_claims, 50);
}

TEST(PlainlyOutside, ATetrahedronThatTouchesTheBallIsNot) {
  const Tet touching = {Vec3{1, -1, -1}, {1, 1, -1}, {1, 0, 2}, {2, 0, 0}};  // its first facet, at (1, 0, 0)
  EXPECT_FALSE(make_ball({0, 0, 0}, 1)->plainly_outside(touching));
  EXPECT_TRUE(make_ball({0, 0, 0}, 0.999)->plainly_outside(touching));
}

}  // namespace
}  // namespace unsliver
