#include <limits>

#include "sizing_properties.hpp"

namespace unsliver {
namespace {

using namespace test;

const Box3 kCube{{-1, -1, -1}, {1, 1, 1}};

/// inf over q in the cube of s(q) + g |p - q|, from above, by dense sampling.
double ideal_limit(const Sizing& s, double g, const Vec3& p, int n) {
  double least = s.at(p);
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const Vec3 q = Vec3{-1, -1, -1} + (2.0 / n) * Vec3{double(i), double(j), double(k)};
        least = std::min(least, s.at(q) + g * dist(p, q));
      }
  return least;
}

void expect_limited(const char* text, double g, double worst_ratio) {
  SCOPED_TRACE(text);
  const SizingPtr s = expression_size(text, kCube);
  const SizingPtr limited = limit_gradation(s, g, kCube);
  EXPECT_EQ(limited->lipschitz(), g);
  expect_sound(*limited, kCube, 500);
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.in(kCube);
    ASSERT_LE(limited->at(p), s->at(p)) << "never above s";
  }
  for (int i = 0; i < 15; ++i) {
    const Vec3 p = random.in(kCube);
    const double ideal = ideal_limit(*s, g, p, 30);
    ASSERT_LE(limited->at(p), ideal * (1 + 1e-12));
    ASSERT_GE(limited->at(p), worst_ratio * ideal) << "not far below the ideal";
  }
}

TEST(LimitGradation, SteepSlopesAreCutToTheGradation) {
  expect_limited("0.1 + 2*abs(x)", 0.3, 0.95);
  expect_limited("0.1 + 2*sqrt(x*x+y*y+z*z)", 0.25, 0.9);
  expect_limited("0.2 + 0.15*sin(6*x)*sin(5*y)", 0.4, 0.7);
}

TEST(LimitGradation, JumpsBecomeRamps) {
  expect_limited("x + 0.3*y < 0.1 ? 0.2 : 1", 0.5, 0.9);
  const SizingPtr step = expression_size("x < 0.125 ? 0.2 : 5", kCube);
  const SizingPtr limited = limit_gradation(step, 0.5, kCube);
  EXPECT_NEAR(limited->at({-0.5, 0, 0}), 0.2, 1e-12);
  EXPECT_NEAR(limited->at({0.925, 0, 0}), 0.2 + 0.5 * 0.8, 0.02);
  EXPECT_NE(limited->notes().back().find("gradation was limited by"), std::string::npos);
}

TEST(LimitGradation, WhatIsGentleEnoughIsLeftAlone) {
  const SizingPtr s = expression_size("0.5 + 0.25*x", kCube);
  EXPECT_EQ(limit_gradation(s, 0.26, kCube), s);
  EXPECT_NE(limit_gradation(s, 0.24, kCube), s);
}

TEST(LimitGradation, InfinityIsLimitedByWhatIsFinite) {
  const SizingPtr s = expression_size("1/max(0, x) ", kCube);
  const SizingPtr limited = limit_gradation(s, 0.5, kCube);
  expect_sound(*limited, kCube, 500);
  EXPECT_NEAR(limited->at({1, 0, 0}), 1, 0.03);
  EXPECT_NEAR(limited->at({-1, 0, 0}), 2, 0.05);
}

TEST(LimitGradation, RefusesBadInput) {
  const SizingPtr s = constant_size(1);
  for (double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    expect_error([&] { limit_gradation(s, bad, kCube); }, ErrorCode::kBadOption, "gradation");
  expect_error([&] { limit_gradation(s, 1, Box3{}); }, ErrorCode::kBadInput, "bounds");
}

}  // namespace
}  // namespace unsliver
