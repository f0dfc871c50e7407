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

}  // namespace
}  // namespace unsliver
