#include "geom/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "random_formula.hpp"
#include "unsliver/error.hpp"

namespace unsliver::geom {
namespace {

using test::Random;

double value(const std::string& text, const Vec3& p = {}) { return Expression::parse(text).at(p); }

std::string fault(const std::string& text) {
  try {
    Expression::parse(text);
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::kBadOption);
    return e.what();
  }
  return "accepted";
}

TEST(Expression, PrecedenceAndAssociativity) {
  EXPECT_EQ(value("1+2*3"), 7);
  EXPECT_EQ(value("(1+2)*3"), 9);
  EXPECT_EQ(value("10-4-3"), 3);
  EXPECT_EQ(value("16/4/2"), 2);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("2^-2^2"), 0.0625);
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("--+3"), 3);
  EXPECT_EQ(value("-x^2", {3, 0, 0}), -9);
  EXPECT_EQ(value("1+1<3"), 1);
  EXPECT_EQ(value("0 ? 1 : 0 ? 2 : 3"), 3);
  EXPECT_EQ(value("1 ? 0 ? 4 : 5 : 6"), 5);
  EXPECT_EQ(value("1 < 2 ? 3 + 4 : 5"), 7);
  EXPECT_EQ(value(" 1.5e1\t+ .5 +\n2."), 17.5);
}

TEST(Expression, ComparisonsAtAndOffEquality) {
  for (double x : {1.0, 2.0, 3.0}) {
    const Vec3 p{x, 2, 0};
    EXPECT_EQ(value("x<y", p), x < 2);
    EXPECT_EQ(value("x<=y", p), x <= 2);
    EXPECT_EQ(value("x>y", p), x > 2);
    EXPECT_EQ(value("x>=y", p), x >= 2);
  }
}

TEST(Expression, EveryFunctionMeansItsNamesake) {
  struct Case {
    const char* text;
    std::function<double(double, double, double)> direct;
  };
  const Case cases[] = {
      {"abs(x)", [](double x, double, double) { return std::fabs(x); }},
      {"min(x, y, z)",
       [](double x, double y, double z) {
         return std::min({x, y, z});
       }},
      {"max(x, y, z)",
       [](double x, double y, double z) {
         return std::max({x, y, z});
       }},
      {"sqrt(abs(x))", [](double x, double, double) { return std::sqrt(std::fabs(x)); }},
      {"cbrt(x)", [](double x, double, double) { return std::cbrt(x); }},
      {"exp(y)", [](double, double y, double) { return std::exp(y); }},
      {"log(2+x)", [](double x, double, double) { return std::log(2 + x); }},
      {"log10(2+x)", [](double x, double, double) { return std::log10(2 + x); }},
      {"sin(x)+cos(y)*tan(z)",
       [](double x, double y, double z) { return std::sin(x) + std::cos(y) * std::tan(z); }},
      {"asin(x)", [](double x, double, double) { return std::asin(x); }},
      {"acos(x)-atan(z)", [](double x, double, double z) { return std::acos(x) - std::atan(z); }},
      {"atan2(y,x)", [](double x, double y, double) { return std::atan2(y, x); }},
      {"sinh(x)/cosh(y)+tanh(z)",
       [](double x, double y, double z) { return std::sinh(x) / std::cosh(y) + std::tanh(z); }},
      {"floor(3*x)+ceil(5*y)",
       [](double x, double y, double) { return std::floor(3 * x) + std::ceil(5 * y); }},
      {"sign(x)", [](double x, double, double) { return static_cast<double>((x > 0) - (x < 0)); }},
      {"hypot(x,y,z)", [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }},
      {"sqrt(x*x+y^2+z*z)", [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }},
      {"if(x<y, x, z)", [](double x, double y, double z) { return x < y ? x : z; }},
      {"clamp(x,-0.25,0.5)", [](double x, double, double) { return std::clamp(x, -0.25, 0.5); }},
      {"2*pi*x-e", [](double x, double, double) { return 2 * std::numbers::pi * x - std::numbers::e; }},
      {"abs(x)^y", [](double x, double y, double) { return std::pow(std::fabs(x), y); }},
      {"x^3", [](double x, double, double) { return x * x * x; }},
      {"x^-2", [](double x, double, double) { return 1 / (x * x); }},
      {"x^200", [](double x, double, double) { return std::pow(x, 200); }},
  };
  for (const Case& c : cases) {
    const Expression f = Expression::parse(c.text);
    EXPECT_EQ(f.text(), c.text);
    Random random(7);
    for (int i = 0; i < 200; ++i) {
      const Vec3 p = random.in({{-1, -1, -1}, {1, 1, 1}});
      EXPECT_DOUBLE_EQ(f.at(p), c.direct(p.x, p.y, p.z)) << c.text;
    }
  }
}

TEST(Expression, NanIsNeverSwallowed) {
  for (const char* text : {"min(1, sqrt(x))", "max(sqrt(x), 1)", "sqrt(x) < 1", "1 >= sqrt(x)",
                           "clamp(log(x),0,1)", "if(sqrt(x), 1, 2)", "hypot(sqrt(x), 1)", "sign(log(x))"}) {
    EXPECT_TRUE(std::isnan(value(text, {-1, 0, 0}))) << text;
    EXPECT_TRUE(Expression::parse(text).over({{-2, 0, 0}, {-1, 1, 1}}).may_be_nan) << text;
  }
  EXPECT_EQ(value("x < 0 ? 5 : sqrt(x)", {-1, 0, 0}), 5) << "an arm that is not taken does no harm";
  EXPECT_EQ(value("1/x", {-0.0, 0, 0}), std::numeric_limits<double>::infinity());
}

TEST(Expression, FaultsNameTheirColumn) {
  const auto names = [](const std::string& text, const std::string& column, const std::string& expected) {
    const std::string what = fault(text);
    EXPECT_NE(what.find("column " + column + ":"), std::string::npos) << what;
    EXPECT_NE(what.find(expected), std::string::npos) << what;
  };
  names("", "1", "found the end");
  names("1 + * 2", "5", "expected a number");
  names("2x", "2", "expected an operator");
  names("foo(1)", "1", "expected one of x, y, z");
  names("sin x", "5", "expected \"(\"");
  names("sin(x, y)", "9", "1 argument of sin");
  names("atan2(1)", "8", "2 arguments of atan2");
  names("min(1)", "6", "at least 2 arguments of min");
  names("(1", "3", "expected \")\"");
  names("1)", "2", "expected an operator");
  names("x ? 1", "6", "expected \":\"");
  names("1e999", "1", "range of a double");
  names("x ** 2", "4", "powers are written with ^");
  names("x < y < z", "7", "no second comparison");
  names("x == y", "3", "expected an operator");
  names("1 + \xc3\xa9", "5", "expected a number");
  names(".", "1", "expected a number");
  names("x &", "3", "expected an operator");
}

TEST(Expression, HugeAndDeepInputsAreRefusedNotCrashed) {
  const auto repeat = [](const std::string& s, int n) {
    std::string r;
    for (int i = 0; i < n; ++i) r += s;
    return r;
  };
  EXPECT_NE(fault(repeat("(", 30000)).find("nested"), std::string::npos);
  EXPECT_NE(fault(repeat("-", 30000) + "1").find("nested"), std::string::npos);
  EXPECT_NE(fault(repeat("2^", 30000) + "1").find("nested"), std::string::npos);
  EXPECT_NE(fault(repeat("1?2:", 16000) + "1").find("nested"), std::string::npos);
  EXPECT_NE(fault(repeat("sin(", 16000)).find("nested"), std::string::npos);
  EXPECT_NE(fault(repeat(" ", 70000)).find("70000 characters"), std::string::npos);
  EXPECT_EQ(value(repeat("(", 199) + "x" + repeat(")", 199), {4, 0, 0}), 4);
  EXPECT_EQ(value(repeat("x+", 30000) + "0", {1, 0, 0}), 30000);
  EXPECT_EQ(value(repeat("x+(", 150) + "0" + repeat(")", 150), {1, 0, 0}), 150) << "deep stack";
}

/// Checks that over, tight_over and enclosure_over tell the truth about a formula on one box.
void expect_sound(const Expression& f, const Box3& box, Random& random) {
  bool may_be_nan = false;
  const Interval range = f.over(box, &may_be_nan), tight = f.tight_over(box);
  const Dual d = f.enclosure_over(box);
  EXPECT_EQ(may_be_nan, range.may_be_nan);
  for (int i = 0; i < 12; ++i) {
    const Vec3 p = random.point_of(box);
    const double v = f.at(p);
    ASSERT_TRUE(range.contains(v)) << v << " not in [" << range.lo << ", " << range.hi << "]";
    ASSERT_TRUE(tight.contains(v)) << v << " not in [" << tight.lo << ", " << tight.hi << "]";
    ASSERT_TRUE(d.value.contains(v));
    const Vec3 elsewhere = random.point_of(box);
    const double difference = std::fabs(f.at(elsewhere) - v);
    if (std::isfinite(difference) && std::isfinite(d.steepness) && d.rounding < 1e-3) {
      ASSERT_LE(difference, (d.steepness * dist(p, elsewhere) + 2 * d.rounding) * (1 + 1e-12));
    }
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 q = p;
      q[axis] = random.point_of(box)[axis];
      const double change = f.at(q) - v, step = q[axis] - p[axis];
      if (step == 0 || std::isnan(change) || d.value.may_be_nan || !(d.rounding < 1e-3)) continue;
      const Interval& slope = d.slope[static_cast<std::size_t>(axis)];
      ASSERT_LE(std::fabs(change), (slope.magnitude() * std::fabs(step) + 2 * d.rounding) * (1 + 1e-12))
          << "axis " << axis << ", slope [" << slope.lo << ", " << slope.hi << "]";
    }
  }
}

TEST(Expression, BoundsAreSoundForRandomFormulas) {
  const int runs = std::getenv("UNSLIVER_LONG") ? 2000000 : 30000;
  for (int seed = 1; seed <= runs; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const std::string text = random_formula(random, 1 + static_cast<int>(random.below(8)));
    const Box3 box = random.box(random.below(2) ? 1.5 : 20.0);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ": " << text << " over " << box.lo.x << " "
                                    << box.lo.y << " " << box.lo.z << " .. " << box.hi.x << " " << box.hi.y
                                    << " " << box.hi.z);
    expect_sound(Expression::parse(text), box, random);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(Expression, DerivativesOfTheUsualFormulasAreTight) {
  const Expression distance = Expression::parse("0.1 + 0.3*sqrt((x-1)^2 + y*y + z*z)");
  const Box3 around_apex{{0, -1, -1}, {2, 1, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(distance.derivative_over(around_apex, axis).magnitude(), 0.3, 1e-14);
  }
  EXPECT_NEAR(distance.enclosure_over(around_apex).steepness, 0.3, 1e-14) << "not 0.3 sqrt(3)";
  const Expression wave = Expression::parse("sin(3*x)*y");
  const Box3 point{{0.2, 2, 0}, {0.2, 2, 0}};
  EXPECT_NEAR(wave.derivative_over(point, 0).lo, 6 * std::cos(0.6), 1e-13);
  EXPECT_NEAR(wave.derivative_over(point, 1).hi, std::sin(0.6), 1e-13);
  EXPECT_EQ(wave.derivative_over(point, 2).magnitude(), 0);
}

TEST(Expression, JumpsHaveUnboundedDerivatives) {
  const Box3 box{{-1, -1, -1}, {1, 1, 1}};
  for (const char* text :
       {"x < 0.2 ? 1 : 2", "floor(x)", "sign(x)", "1/x", "tan(2*x)", "atan2(x, -1)", "x >= 0"}) {
    EXPECT_EQ(Expression::parse(text).derivative_over(box, 0).magnitude(),
              std::numeric_limits<double>::infinity())
        << text;
    EXPECT_EQ(Expression::parse(text).derivative_over(box, 1).magnitude(), 0) << text;
  }
}

TEST(Expression, MeanValueFormConvergesQuadratically) {
  const Expression f = Expression::parse("x*x - 2*x*y + sin(x)*z + exp(y)/(2+z)");
  double last_excess = 0;
  for (int k = 3; k <= 8; ++k) {
    const double h = std::ldexp(1.0, -k);
    const Box3 box{{0.7, 0.4, 0.1}, {0.7 + h, 0.4 + h, 0.1 + h}};
    Interval seen{1e9, -1e9};
    for (int i = 0; i < 9 * 9 * 9; ++i) {
      const Vec3 t{(i % 9) / 8.0, (i / 9 % 9) / 8.0, (i / 81) / 8.0};
      const double v = f.at(box.lo + h * t);
      seen = {std::min(seen.lo, v), std::max(seen.hi, v)};
    }
    const Interval r = f.tight_over(box);
    const double excess = (r.hi - r.lo) - (seen.hi - seen.lo);
    EXPECT_GT(excess, 0);
    if (last_excess > 0) {
      EXPECT_LT(excess, 0.4 * last_excess) << "side " << h;
    }
    last_excess = excess;
  }
}

}  // namespace
}  // namespace unsliver::geom
