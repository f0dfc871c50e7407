/// Bounds as rationals: exact where they can be, near and on the safe side elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "exact/quality_signs.hpp"

namespace unsliver::exact {
namespace {

constexpr std::int64_t kLargest = (1 << 20) - 1;

void expect_bound(const CosBound& bound, int sign, std::int64_t num, std::int64_t den) {
  EXPECT_EQ(bound.sign, sign);
  EXPECT_EQ(bound.num, num);
  EXPECT_EQ(bound.den, den);
}

TEST(QualityBounds, AnglesWithRationalCosineSquaredAreExact) {
  for (bool is_min : {false, true}) {
    expect_bound(cos_bound(30, is_min), 1, 3, 4);
    expect_bound(cos_bound(45, is_min), 1, 1, 2);
    expect_bound(cos_bound(60, is_min), 1, 1, 4);
    expect_bound(cos_bound(90, is_min), 0, 0, 1);
    expect_bound(cos_bound(120, is_min), -1, 1, 4);
    expect_bound(cos_bound(135, is_min), -1, 1, 2);
    expect_bound(cos_bound(150, is_min), -1, 3, 4);
  }
}

/// The signed square of the cosine falls with the angle, so a smaller angle has a larger one.
long double signed_square(const CosBound& b) {
  return b.sign * static_cast<long double>(b.num) / static_cast<long double>(b.den);
}

TEST(QualityBounds, OtherAnglesAreNearAndNeverDemandMore) {
  for (int n = 1; n < 1800; n += 7) {
    const double degrees = n / 10.0 + 0.0123;
    const long double cosine = std::cos(static_cast<long double>(degrees) * 3.14159265358979323846L / 180);
    const long double wanted = cosine * std::abs(cosine);
    for (bool is_min : {false, true}) {
      const CosBound bound = cos_bound(degrees, is_min);
      ASSERT_LT(bound.num, 1 << 20);
      ASSERT_LT(bound.den, 1 << 20);
      const long double excess = is_min ? signed_square(bound) - wanted : wanted - signed_square(bound);
      ASSERT_GE(excess, -1e-14L) << degrees;
      ASSERT_LE(excess, 1e-6L) << degrees;
    }
  }
}

TEST(QualityBounds, AnglesNearTheEndsOfTheRangeStaySafe) {
  expect_bound(cos_bound(1e-6, true), 1, 1, 1);
  expect_bound(cos_bound(180 - 1e-6, false), -1, 1, 1);
  expect_bound(cos_bound(90 - 1e-6, false), 0, 0, 1);
  expect_bound(cos_bound(90 + 1e-6, true), 0, 0, 1);
}

TEST(QualityBounds, RatiosAreExactWhereTheirSquareIsASmallFraction) {
  for (std::int64_t num : {1, 2, 3, 5, 9, 25, 1000})
    for (std::int64_t den : {1, 4, 7, 11, 999}) {
      const RatioBound bound = ratio_bound(std::sqrt(static_cast<double>(num) / static_cast<double>(den)));
      EXPECT_EQ(bound.num * den, num * bound.den);
    }
}

/// Of all fractions with a denominator up to the limit none is nearer from above.
TEST(QualityBounds, RatiosAreRoundedUpToTheNearestFraction) {
  for (double ratio : {0.61237, 1.1180341, 1.41421, 2.71828, 999.5}) {
    const double square = ratio * ratio;
    const RatioBound bound = ratio_bound(ratio);
    const double got = static_cast<double>(bound.num) / static_cast<double>(bound.den);
    ASSERT_GE(got, square * (1 - 1e-14));
    for (std::int64_t den = 1; den <= kLargest; ++den) {
      const double num = std::ceil(square * static_cast<double>(den));
      if (num <= kLargest) {
        ASSERT_LE(got, num / static_cast<double>(den) * (1 + 1e-14)) << den;
      }
    }
  }
}

}  // namespace
}  // namespace unsliver::exact
