// Theorem 8 and Table 1, and the same with another forbidden region or other numbers.
#include "prove/theorem_8.hpp"

#include "differs.hpp"

namespace unsliver::prover {
namespace {

TEST(Theorem8, Holds) { expect_as_recorded(prove_theorem_8()); }

// 4 sigma = 2 + sqrt 6 is 4.449...: with a smaller region p comes into spheres of lattice cells in cases 1
// and 2.
TEST(Theorem8, DiffersForASmallerRegion) {
  const Finding finding = prove_theorem_8({.four_sigma = Surd(-3, 3)});  // 4.348
  EXPECT_GE(count_of_differences(finding), 2);
  EXPECT_FALSE(finding.back().holds);  // no longer the least possible
}

TEST(Theorem8, DiffersForARegionThatCoversOtherPoints) {
  EXPECT_FALSE(prove_theorem_8({.four_sigma = Surd(7)}).front().holds);
}

TEST(Theorem8, DiffersFromOtherCounts) {
  expect_differences(4, prove_theorem_8({.face_vertices = {23, 33, 41, 55}}));
}

TEST(Table1, Holds) { expect_as_recorded(prove_table_1()); }

TEST(Table1, DiffersFromOtherNumbers) {
  Table1 claim;
  claim.least = {31'964, 30'127, 30'002, 34'783};
  claim.greatest[2] = 127'901;
  claim.greatest_is_intrinsic[0] = false;
  claim.ratio = {1'197, 1'269, 1'331, 1'366};
  claim.least_signed_cos_sq = {74, 100};
  claim.greatest_bound = 127'902;
  claim.ratio_bound = 1'367;
  expect_differences(4 + 2 + 4 + 4, prove_table_1(claim));
}

TEST(Table1, DiffersForASmallerRegion) {
  const Finding finding = prove_table_1({.four_sigma = Surd(-3, 3)});
  EXPECT_GE(count_of_differences(finding), 8);
}

// The search itself: the largest of a quantity over a box, against a grid of exact values.
TEST(Largest, IsNoLessThanOnAGridAndAttained) {
  const Hole hole(2);
  const Region region = hole.region(kFourSigma);
  for (const auto kind : {Quantity::kSmallAngle, Quantity::kLargeAngle, Quantity::kRatio}) {
    const auto& base = hole.bases()[5];
    const Quantity quantity{kind, {base[0], base[1], base[2]}, 0, 3};
    const Extreme found = largest({quantity}, region);
    ASSERT_TRUE(found.is_certain);
    ASSERT_FALSE(found.places.empty());
    const auto value_at = [&](const Vector<Surd>& p, int scale) {
      const Quotient<Surd> q = quantity.at(p, scale);
      return SurdFraction{q.num, q.den};
    };
    EXPECT_TRUE(value_at(corner(region, found.places[0].corner), 4) == found.value);
    constexpr int kSteps = 4;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; j <= kSteps; ++j)
        for (int k = 0; k <= kSteps; ++k) {
          const auto between = [&](int axis, int n) {
            const Range& range = region[std::size_t(axis)];
            return Surd(kSteps - n) * range.lo + Surd(n) * range.hi;
          };
          EXPECT_FALSE(found.value < value_at({between(0, i), between(1, j), between(2, k)}, 4 * kSteps));
        }
  }
}

}  // namespace
}  // namespace unsliver::prover
