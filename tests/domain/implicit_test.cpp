#include <gtest/gtest.h>

#include "domain/sample_surfaces.hpp"
#include "unsliver/domain.hpp"
#include "unsliver/error.hpp"

namespace unsliver {
namespace {

using samples::Dice;

const Box3 kBounds{{-2, -2, -2}, {2, 2, 2}};

TEST(ImplicitDomain, IsSound) {
  const std::vector<std::string> formulas = {
      "x^2 + y^2 + z^2 - 1",
      "(sqrt(x^2 + y^2) - 1.2)^2 + z^2 - 0.16",
      "max(abs(x), max(abs(y), abs(z))) - 0.9",
      "cos(3*x) + cos(3*y) + cos(3*z)",
      "floor(2*x) + y",
      "log(x) + y^2",
      "x > 0 ? x - 1 : y",
  };
  for (const std::string& formula : formulas) {
    SCOPED_TRACE(formula);
    const DomainPtr domain = make_implicit(formula, kBounds);
    Dice dice(1);
    int met = 0, clear = 0;
    for (int n = 0; n < 600; ++n) {
      SCOPED_TRACE(n);
      const Vec3 p = dice.around({}, 2.2);
      const Tet t = dice.tet_around(p, n % 2 ? 0.1 : 0.6);
      bool holds = false;
      for (int i = 0; i < 60; ++i) holds = holds || domain->contains(dice.inside(t));
      const bool meets = domain->meets(t);
      EXPECT_TRUE(meets || !holds);
      met += meets;
      const double radius = domain->clearance(p);
      clear += std::abs(radius) > 1e-3;
      for (int i = 0; i < 20 && radius != 0; ++i)
        EXPECT_EQ(domain->contains(dice.in_ball(p, std::abs(radius))), radius < 0);
    }
    EXPECT_GT(met, 30);
    EXPECT_LT(met, 550);
    EXPECT_GT(clear, 300);
  }
}

/// Meets is tight: tetrahedra a little off a ball do not meet it.
TEST(ImplicitDomain, LeavesOutWhatIsClearlyOutside) {
  const DomainPtr implicit = make_implicit("x^2 + y^2 + z^2 - 1", kBounds), ball = make_ball({}, 1);
  Dice dice(2);
  int outside = 0, disagree = 0;
  for (int n = 0; n < 2000; ++n) {
    const Tet t = dice.tet_around(dice.around({}, 1.5), 0.2);
    if (ball->meets(t)) {
      EXPECT_TRUE(implicit->meets(t)) << n;
    } else {
      ++outside;
      disagree += implicit->meets(t);
    }
  }
  EXPECT_GT(outside, 500);
  EXPECT_LT(disagree, 0.02 * outside);
}

TEST(ImplicitDomain, EndsAtItsBounds) {
  const DomainPtr domain = make_implicit("-1", kBounds);
  EXPECT_TRUE(domain->contains({2, 2, 2}));
  EXPECT_FALSE(domain->contains({2.001, 0, 0}));
  EXPECT_NEAR(domain->clearance({0, 0, 0}), -2, 0.1);
  EXPECT_NEAR(domain->clearance({5, 0, 0}), 3, 1e-12);
  EXPECT_FALSE(domain->meets({{{2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {2, 0, 1}}}));
  EXPECT_NEAR(domain->volume(), 64, 1e-9);
}

TEST(ImplicitDomain, VolumeOfABall) {
  EXPECT_NEAR(make_implicit("x^2 + y^2 + z^2 - 1", kBounds)->volume(), 4.19, 0.1);
}

TEST(ImplicitDomain, ATinyBallIsFound) {
  const DomainPtr domain = make_implicit("(x-1.2345)^2 + (y+0.777)^2 + (z-0.1)^2 - 1e-6", kBounds);
  EXPECT_TRUE(domain->contains({1.2345, -0.777, 0.1}));
  EXPECT_TRUE(domain->meets({{{1, -1, 0}, {2, -1, 0}, {1, 0, 0}, {1, -1, 1}}}));
}

ErrorCode code_of(const std::string& formula, const Box3& bounds) {
  try {
    make_implicit(formula, bounds);
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::kInternal;
}

TEST(ImplicitDomain, BadInputIsRefused) {
  EXPECT_EQ(code_of("x^2 + y^2 + z^2 + 1", kBounds), ErrorCode::kBadInput);
  EXPECT_EQ(code_of("1 - x*x*0", kBounds), ErrorCode::kBadInput);
  EXPECT_EQ(code_of("log(-1 - x^2)", kBounds), ErrorCode::kBadInput);
  EXPECT_EQ(code_of("x^2 +", kBounds), ErrorCode::kBadOption);
  EXPECT_EQ(code_of("x^2 + q", kBounds), ErrorCode::kBadOption);
  EXPECT_EQ(code_of("x", {{0, 0, 0}, {0, 1, 1}}), ErrorCode::kBadInput);
}

}  // namespace
}  // namespace unsliver
