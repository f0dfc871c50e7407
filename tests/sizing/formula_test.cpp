#include <limits>

#include "sizing_properties.hpp"

namespace unsliver {
namespace {

using namespace test;

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kNan = std::numeric_limits<double>::quiet_NaN();
const Box3 kCube{{-1, -1, -1}, {1, 1, 1}};
const Box3 kWider{{-2, -2, -2}, {2, 2, 2}};

TEST(ConstantSize, IsConstant) {
  const SizingPtr s = constant_size(0.1);
  EXPECT_EQ(s->at({5, 6, 7}), 0.1);
  EXPECT_EQ(s->lower_bound(kCube), 0.1);
  EXPECT_EQ(s->lipschitz(), 0);
  EXPECT_EQ(s->describe(), "constant 0.1");
  EXPECT_TRUE(s->notes().empty());
}

TEST(ConstantSize, RefusesWhatIsNoSize) {
  for (double bad : {0.0, -1.0, kNan, kInf})
    expect_error([bad] { constant_size(bad); }, ErrorCode::kBadOption, "The size is");
}

TEST(ExpressionSize, IsSoundAndTight) {
  struct Case {
    const char* text;
    double steepness;
  };
  for (const Case& c : {Case{"0.1", 0}, Case{"0.5 + 0.25*x - 0.1*y", 0.6},
                        Case{"0.05 + 0.3*sqrt(x*x + y*y + z*z)", 0.9}, Case{"0.2 + 0.1*sin(5*x)*cos(3*y)", 1},
                        Case{"max(0.1, min(abs(x), 0.5))", 1.5}, Case{"0.01 + exp(-4*(x^2+y^2))", 8},
                        Case{"1/(2 + x*y*z)", 2}, Case{"0.1 + hypot(x - 0.3, y)*(1 + 0.5*z)", 3},
                        Case{"0.3 + x^3/4 + z^4/8", 2}, Case{"x < 0.25 ? 0.1 : 0.1 + (x - 0.25)", kInf},
                        Case{"0.5 + 0.1*floor(4*x)", kInf}, Case{"0.02 + sqrt(abs(z))", kInf}}) {
    const SizingPtr s = expression_size(c.text, kCube);
    expect_sound(*s, kWider);
    if (c.steepness < kInf) expect_tight(*s, kWider, c.steepness);
  }
}

TEST(ExpressionSize, LipschitzConstantIsCloseToTheTrueOne) {
  EXPECT_EQ(expression_size("0.25", kCube)->lipschitz(), 0);
  EXPECT_NEAR(expression_size("0.1 + 0.3*sqrt(x^2+y^2+z^2)", kCube)->lipschitz(), 0.3, 1e-9);
  EXPECT_NEAR(expression_size("3 + x + 2*y", kCube)->lipschitz(), std::sqrt(5.0), 1e-9);
  EXPECT_NEAR(expression_size("1 + x*x*y", kCube)->lipschitz(), std::sqrt(5.0), 0.05);
  EXPECT_EQ(expression_size("x < 0 ? 1 : 2", kCube)->lipschitz(), kInf);
}

TEST(ExpressionSize, TheWholeBoxHasASharpBound) {
  // Plain interval evaluation gives -0.9 here; callers fit their unit to this number.
  const SizingPtr s = expression_size("0.1 + (x - y)^2 - 0.5*(x - y)*(x - y) + 0*z", kCube);
  EXPECT_GT(s->lower_bound(kCube), 0.09);
  EXPECT_GT(s->lower_bound(kWider), 0.09);
}

TEST(ExpressionSize, OutsideItsBoundsItStaysThatOfTheNearestPoint) {
  const SizingPtr s = expression_size("1.5 + x", kCube);
  EXPECT_EQ(s->at({-7, 3, 0}), 0.5);
  EXPECT_EQ(s->at({9, 0, 0}), 2.5);
  EXPECT_NE(s->notes().at(0).find("outside (-1, -1, -1) to (1, 1, 1)"), std::string::npos);
}

TEST(ExpressionSize, NamesThePointWhereItIsNoSize) {
  const SizingPtr s = expression_size("x", kCube);
  EXPECT_EQ(s->at({0.5, 0, 0}), 0.5);
  EXPECT_GT(s->lower_bound(kCube), 0) << "the contract asks for a positive bound";
  EXPECT_NEAR(s->lower_bound({{0.5, 0, 0}, {0.5, 1, 1}}), 0.5, 1e-12);
  const Error e = expect_error(
      [&] {
        s->at({-0.25, 0.5, 0.75});
      },
      ErrorCode::kBadInput, "The size at (-0.25, 0.5, 0.75) is -0.25");
  ASSERT_EQ(e.places.size(), 1u);
  EXPECT_EQ(e.places[0], (Vec3{-0.25, 0.5, 0.75}));
  expect_error([&] { s->at({0, 0, 0}); }, ErrorCode::kBadInput, "is 0,");
  expect_error([] { expression_size("sqrt(x)", kCube)->at({-1, 0, 0}); }, ErrorCode::kBadInput, "nan");
  EXPECT_EQ(expression_size("1/abs(x)", kCube)->at({0, 0, 0}), kInf) << "infinity is allowed";
}

TEST(ExpressionSize, RefusesBadInput) {
  expect_error([] { expression_size("1 +", kCube); }, ErrorCode::kBadOption, "column 4");
  expect_error([] { expression_size("1", Box3{}); }, ErrorCode::kBadInput, "bounds");
  expect_error([] { expression_size("1", {{0, 0, 0}, {1, 0, 1}}); }, ErrorCode::kBadInput, "positive sides");
  expect_error([] { expression_size("1", {{0, 0, 0}, {1, kInf, 1}}); }, ErrorCode::kBadInput, "finite");
}

TEST(MinimumSize, IsTheLeastOfItsParts) {
  const SizingPtr a = expression_size("0.5 + 0.25*x", kCube), b = expression_size("0.6 - 0.5*y", kCube);
  const SizingPtr s = minimum_size({a, b, constant_size(0.55)});
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = random.in(kWider);
    EXPECT_EQ(s->at(p), std::min({a->at(p), b->at(p), 0.55}));
  }
  expect_sound(*s, kWider);
  expect_tight(*s, kWider, 1);
  EXPECT_NEAR(s->lipschitz(), 0.5, 1e-9);
  EXPECT_EQ(s->notes().size(), a->notes().size() + b->notes().size());
  EXPECT_EQ(s->describe(), "minimum of: expression 0.5 + 0.25*x; expression 0.6 - 0.5*y; constant 0.55");
}

TEST(MinimumSize, OfOneIsThatOneAndOfNoneAnError) {
  const SizingPtr a = constant_size(1);
  EXPECT_EQ(minimum_size({a}), a);
  expect_error([] { minimum_size({}); }, ErrorCode::kBadOption, "at least one");
}

}  // namespace
}  // namespace unsliver
