/// Every sign against unlimited integers, every stage reached, every symmetry.
#include "exact/predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "generators.hpp"
#include "reference.hpp"

namespace unsliver::exact {
namespace {

using reference::Five;

int orientation(const Five& p, StageCounts& counts) { return orient3d(p[0], p[1], p[2], p[3], counts); }
int conflict(const Five& p, StageCounts& counts) { return insphere(p[0], p[1], p[2], p[3], p[4], counts); }
int perturbed(const Five& p, StageCounts& counts) {
  return insphere_perturbed(p[0], p[1], p[2], p[3], p[4], counts);
}

/// All three predicates against the reference; swaps two points where that makes the rest positive.
void check(Five p, StageCounts& counts) {
  const int orient = orientation(p, counts);
  ASSERT_EQ(orient, reference::orient3d(p[0], p[1], p[2], p[3]));
  ASSERT_EQ(conflict(p, counts), reference::insphere(p));
  if (orient == 0 || !last_is_distinct(p)) return;
  if (orient < 0) std::swap(p[0], p[1]);
  ASSERT_EQ(perturbed(p, counts), reference::insphere_perturbed(p));
}

TEST(Predicates, SignConvention) {
  StageCounts counts;
  const Vec3 o{0, 0, 0}, x{4, 0, 0}, y{0, 4, 0}, z{0, 0, 4};
  EXPECT_EQ(orient3d(o, x, y, z, counts), 1);
  EXPECT_EQ(orient3d(o, y, x, z, counts), -1);
  EXPECT_EQ(orient3d(o, x, y, {3, 5, 0}, counts), 0);
  EXPECT_EQ(insphere(o, x, y, z, {1, 1, 1}, counts), 1);
  EXPECT_EQ(insphere(o, x, y, z, {5, 5, 5}, counts), -1);
  EXPECT_EQ(insphere(o, x, y, z, {4, 4, 4}, counts), 0);
}

TEST(Predicates, RandomPointsOfAllMagnitudes) {
  SCOPED_TRACE("seed 1");
  Generator random(1);
  StageCounts counts;
  for (int n = 0; n < 12000; ++n) ASSERT_NO_FATAL_FAILURE(check(random.vectors<5>(1 + n % 48), counts));
  EXPECT_GT(counts.tie, 0U);
}

TEST(Predicates, NearlyAndExactlyCosphericalPointsOfAllMagnitudes) {
  SCOPED_TRACE("seed 2");
  Generator random(2);
  StageCounts counts;
  for (int n = 0; n < 6000; ++n) {
    Five p = random.cospherical<5>(2 + n % 46);
    ASSERT_NO_FATAL_FAILURE(check(p, counts));
    random.nudge(p);
    ASSERT_NO_FATAL_FAILURE(check(p, counts));
  }
  EXPECT_GT(counts.wide, 0U);
  EXPECT_GT(counts.tie, 0U);
}

TEST(Predicates, NearlyAndExactlyCoplanarPointsOfAllMagnitudes) {
  SCOPED_TRACE("seed 3");
  Generator random(3);
  StageCounts counts;
  for (int n = 0; n < 6000; ++n) {
    Five p = random.coplanar<5>(1 + n % 22);
    ASSERT_NO_FATAL_FAILURE(check(p, counts));
    random.nudge(p);
    ASSERT_NO_FATAL_FAILURE(check(p, counts));
  }
  EXPECT_GT(counts.wide, 0U);
}

TEST(Predicates, LatticeNeighbourhoodsNeverNeedWideIntegers) {
  SCOPED_TRACE("seed 4");
  Generator random(4);
  StageCounts counts;
  for (int n = 0; n < 12000; ++n) {
    const double side = std::ldexp(1.0, 1 + n % 38);
    ASSERT_NO_FATAL_FAILURE(check(random.lattice<5>(2 + n % 3, side, n % 2 == 0), counts));
  }
  EXPECT_EQ(counts.wide, 0U);
  EXPECT_GT(counts.small, 1000U);
  EXPECT_GT(counts.tie, 500U);
}

/// Eight levels of refinement met in one place: the coarse cell is 2^8 fine ones.
TEST(Predicates, CubesOfManyFineCellsStayInDoubles) {
  StageCounts counts;
  for (double side = 2; side <= 0x1p9; side *= 2) {
    const Vec3 o{1, 1, 1}, x{side + 1, 1, 1}, y{1, side + 1, 1}, z{1, 1, side + 1};
    EXPECT_EQ(insphere(o, x, y, z, {side + 1, side + 1, side + 1}, counts), 0);
    EXPECT_EQ(insphere(o, x, y, z, {side, side + 1, side + 1}, counts), 1);
  }
  EXPECT_EQ(counts.wide, 0U);
}

TEST(Predicates, EveryStageIsReached) {
  StageCounts counts;
  const auto cube = [&counts](double side) {
    return insphere({0, 0, 0}, {side, 0, 0}, {0, side, 0}, {0, 0, side}, {side, side, side}, counts);
  };
  const auto plane = [&counts](double side) {
    return orient3d({1, 0, 0}, {side, side - 1, 0}, {0, side, side + 1}, {1, side, side}, counts);
  };
  EXPECT_EQ(insphere({0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 9}, {1, 1, 1}, counts), 1);
  EXPECT_EQ(counts.filter, 1U);
  EXPECT_EQ(cube(3), 0);
  EXPECT_EQ(cube(0x1p40), 0);
  EXPECT_EQ(cube(0x1p20 - 1), 0);
  EXPECT_EQ(counts.small, 3U);
  EXPECT_EQ(cube(0x1p40 - 1), 0);
  EXPECT_EQ(counts.wide, 1U);
  EXPECT_EQ(plane(8), 0);
  EXPECT_EQ(plane(0x1p30), 0);
  EXPECT_EQ(counts.small, 5U);
  EXPECT_EQ(plane(0x1p46), 0);
  EXPECT_EQ(counts.wide, 2U);
  EXPECT_EQ(counts.tie, 0U);
  const double s = 4;
  EXPECT_NE(insphere_perturbed({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}, {s, s, s}, counts), 0);
  EXPECT_EQ(counts.small, 6U);
  EXPECT_EQ(counts.tie, 1U);
}

int parity(const std::array<std::size_t, 5>& order) {
  int sign = 1;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (order[j] > order[i]) sign = -sign;
  return sign;
}

TEST(Predicates, SwappingTwoPointsFlipsTheSign) {
  SCOPED_TRACE("seed 5");
  Generator random(5);
  StageCounts counts;
  for (int n = 0; n < 300; ++n) {
    Five p = n % 3 == 0   ? random.vectors<5>(2 + n % 46)
             : n % 3 == 1 ? random.cospherical<5>(2 + n % 46)
                          : random.lattice<5>(3, 4, true);
    if (n % 2 == 0) random.nudge(p);
    const int orient = orientation(p, counts), inside = conflict(p, counts);
    std::array<std::size_t, 5> order{};
    std::iota(order.begin(), order.end(), 0U);
    do {
      const Five q = {p[order[0]], p[order[1]], p[order[2]], p[order[3]], p[order[4]]};
      ASSERT_EQ(conflict(q, counts), parity(order) * inside);
      if (order[4] == 4) {
        ASSERT_EQ(orientation(q, counts), parity(order) * orient);
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(Predicates, TranslationAndDyadicScalingChangeNothing) {
  SCOPED_TRACE("seed 6");
  Generator random(6);
  StageCounts counts;
  for (int n = 0; n < 5000; ++n) {
    Five p = n % 2 ? random.cospherical<5>(2 + n % 20) : random.lattice<5>(3, 4, true);
    if (n % 4 < 2) random.nudge(p);
    if (orientation(p, counts) <= 0 || !last_is_distinct(p)) continue;
    const Vec3 offset = random.vector(24);
    const double factor = std::ldexp(1.0, static_cast<int>(random.below(20)));
    Five q = p;
    for (Vec3& v : q) v = factor * (v + offset);
    ASSERT_EQ(orientation(q, counts), 1);
    ASSERT_EQ(conflict(q, counts), conflict(p, counts));
    ASSERT_EQ(perturbed(q, counts), perturbed(p, counts));
  }
}

std::array<double, 5> weights(Generator& random, int bits) {
  std::array<double, 5> w{};
  for (double& v : w) v = random.integer(std::min(bits, 53)) * std::ldexp(1.0, std::max(0, bits - 53));
  return w;
}

int power(const Five& p, const std::array<double, 5>& w, StageCounts& counts) {
  const double plain[5] = {w[0], w[1], w[2], w[3], w[4]};
  return power_test(p[0], p[1], p[2], p[3], p[4], plain, counts);
}

TEST(Predicates, PowerTestOfAllMagnitudes) {
  SCOPED_TRACE("seed 7");
  Generator random(7);
  StageCounts counts;
  for (int n = 0; n < 6000; ++n) {
    const int bits = 2 + n % 46;
    Five p = n % 3 ? random.cospherical<5>(bits) : random.vectors<5>(bits);
    const auto w = weights(random, n % 2 ? 2 * bits : 1 + n % 95);
    ASSERT_EQ(power(p, w, counts), reference::power_test(p, w));
    const std::array<double, 5> equal = {w[0], w[0], w[0], w[0], w[0]};
    ASSERT_EQ(power(p, equal, counts), conflict(p, counts));
  }
  EXPECT_GT(counts.filter, 0U);
  EXPECT_GT(counts.wide, 0U);
}

/// A weight of |p|^2 - h makes the lifted height h: all on one hyperplane, but for one unit.
TEST(Predicates, PowerTestSeesOneUnitOfHeight) {
  SCOPED_TRACE("seed 8");
  Generator random(8);
  StageCounts counts;
  for (int n = 0; n < 2000; ++n) {
    const Five p = random.vectors<5>(25);
    std::array<double, 5> w{};
    for (std::size_t i = 0; i < 5; ++i) w[i] = norm_sq(p[i]) - (p[i].x + 2 * p[i].y - 3 * p[i].z);
    ASSERT_EQ(power(p, w, counts), 0);
    w[random.below(5)] += random.below(2) ? 1 : -1;
    ASSERT_EQ(power(p, w, counts), reference::power_test(p, w));
  }
}

}  // namespace
}  // namespace unsliver::exact
