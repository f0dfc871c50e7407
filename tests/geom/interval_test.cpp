#include "geom/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "geom/expression_run.hpp"
#include "random_formula.hpp"

namespace unsliver::geom {
namespace {

using test::Random;

constexpr double kPi = std::numbers::pi;

struct Unary {
  const char* name;
  Interval (*over)(const Interval&);
  double (*at)(double);
  long double (*exact)(long double);
};

const std::vector<Unary>& unary_functions() {
#define UNSLIVER_LIBM(f)                                                                                     \
  {                                                                                                          \
#f, [](const Interval&                                                                                   \
               a) { return f(a); }, [](double v) { return std::f(v); },                                      \
                                                                     [](long double v) { return std::f(v); } \
  }
  static const std::vector<Unary> functions = {
      UNSLIVER_LIBM(abs),
      UNSLIVER_LIBM(sqrt),
      UNSLIVER_LIBM(cbrt),
      UNSLIVER_LIBM(exp),
      UNSLIVER_LIBM(log),
      UNSLIVER_LIBM(log10),
      UNSLIVER_LIBM(sin),
      UNSLIVER_LIBM(cos),
      UNSLIVER_LIBM(tan),
      UNSLIVER_LIBM(asin),
      UNSLIVER_LIBM(acos),
      UNSLIVER_LIBM(atan),
      UNSLIVER_LIBM(sinh),
      UNSLIVER_LIBM(cosh),
      UNSLIVER_LIBM(tanh),
      UNSLIVER_LIBM(floor),
      UNSLIVER_LIBM(ceil),
      {"square", [](const Interval& a) { return square(a); }, [](double v) { return v * v; },
       [](long double v) { return v * v; }},
  };
#undef UNSLIVER_LIBM
  return functions;
}

/// An interval whose ends are of many scales and often special, as edge cases hide there.
Interval random_interval(Random& random) {
  const auto end = [&random] {
    switch (random.below(6)) {
      case 0:
        return static_cast<double>(random.below(9)) - 4;
      case 1:
        return kPi / 2 * (static_cast<double>(random.below(13)) - 6);
      case 2:
        return random.uniform(-1, 1) * std::ldexp(1.0, static_cast<int>(random.below(60)) - 40);
      case 3:
        return random.uniform(-800, 800);
      default:
        return random.uniform(-2, 2);
    }
  };
  const double a = end(), b = random.below(3) == 0 ? a + random.uniform(0, 1e-3) : end();
  return {std::min(a, b), std::max(a, b)};
}

double sample(Random& random, const Interval& a) {
  if (random.below(4) == 0) return random.below(2) ? a.lo : a.hi;
  return std::clamp(random.uniform(a.lo, a.hi), a.lo, a.hi);
}

bool holds(const Interval& r, long double v) { return std::isnan(v) ? r.may_be_nan : r.lo <= v && v <= r.hi; }

TEST(Interval, NeighboursAreThoseOfTheStandardLibrary) {
  const double inf = kInfinity;
  for (double v : {0.0, -0.0, 1.0, -1.0, 5e-324, -5e-324, 1e308, -1e308, 0x1p-1022, 0.1}) {
    EXPECT_EQ(next_up(v), std::nextafter(v, inf)) << v;
    EXPECT_EQ(next_down(v), std::nextafter(v, -inf)) << v;
  }
  EXPECT_EQ(next_up(inf), inf);
  EXPECT_EQ(next_down(inf), std::numeric_limits<double>::max());
}

TEST(Interval, EveryFunctionHoldsItsValuesAndTheExactOnes) {
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Interval a = random_interval(random);
    for (const Unary& f : unary_functions()) {
      const Interval r = f.over(a);
      ASSERT_LE(r.lo, r.hi) << f.name;
      for (int i = 0; i < 10; ++i) {
        const double v = sample(random, a);
        ASSERT_TRUE(r.contains(f.at(v))) << f.name << " [" << a.lo << ", " << a.hi << "] at " << v;
        ASSERT_TRUE(holds(r, f.exact(v))) << f.name << " exact at " << v;
      }
    }
  }
}

TEST(Interval, BinaryOperationsHoldTheirValues) {
  struct Binary {
    const char* name;
    Interval (*over)(const Interval&, const Interval&);
    double (*at)(double, double);
  };
  const Binary operations[] = {
      {"+", [](auto& a, auto& b) { return a + b; }, [](double a, double b) { return a + b; }},
      {"-", [](auto& a, auto& b) { return a - b; }, [](double a, double b) { return a - b; }},
      {"*", [](auto& a, auto& b) { return a * b; }, [](double a, double b) { return a * b; }},
      {"/", [](auto& a, auto& b) { return divide(a, b); }, [](double a, double b) { return divide(a, b); }},
      {"^", [](auto& a, auto& b) { return power(a, b); }, [](double a, double b) { return power(a, b); }},
      {"atan2", [](auto& a, auto& b) { return atan2(a, b); }, [](double a, double b) { return atan2(a, b); }},
      {"min", [](auto& a, auto& b) { return smaller(a, b); },
       [](double a, double b) { return smaller(a, b); }},
      {"max", [](auto& a, auto& b) { return larger(a, b); }, [](double a, double b) { return larger(a, b); }},
      {"<", [](auto& a, auto& b) { return less(a, b); }, [](double a, double b) { return less(a, b); }},
  };
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Interval a = random_interval(random), b = random_interval(random);
    for (const Binary& f : operations) {
      const Interval r = f.over(a, b);
      ASSERT_LE(r.lo, r.hi) << f.name;
      for (int i = 0; i < 10; ++i) {
        const double u = sample(random, a), v = sample(random, b);
        ASSERT_TRUE(r.contains(f.at(u, v)))
            << f.name << ": " << u << ", " << v << " in [" << a.lo << ", " << a.hi << "], [" << b.lo << ", "
            << b.hi << "] -> [" << r.lo << ", " << r.hi << "]";
      }
    }
  }
}

TEST(Interval, IntegerPowersHoldTheirValues) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Interval a = random_interval(random);
    for (int n : {-64, -3, -2, -1, 1, 2, 3, 4, 7, 10, 63, 64}) {
      const Interval r = power_int(a, n);
      for (int i = 0; i < 5; ++i) {
        const double v = sample(random, a);
        ASSERT_TRUE(r.contains(power_int(v, n))) << v << " ^ " << n;
      }
    }
  }
}

TEST(Interval, PeriodicFunctionsFindTheirExtremes) {
  EXPECT_EQ(sin(Interval{0, kPi}).hi, 1);
  EXPECT_NEAR(sin(Interval{0, kPi}).lo, 0, 1e-15);
  EXPECT_EQ(sin(Interval{4, 5}).lo, -1);
  EXPECT_EQ(cos(Interval{-1, 1}).hi, 1);
  EXPECT_EQ(cos(Interval{3, 4}).lo, -1);
  EXPECT_LT(cos(Interval{0.1, 0.2}).hi, 1);
  EXPECT_NEAR(sin(Interval{100, 100.1}).lo, std::sin(100.0), 1e-12);
  EXPECT_NEAR(sin(Interval{100, 100.1}).hi, std::sin(100.1), 1e-12);
  EXPECT_EQ(tan(Interval{1, 2}).hi, kInfinity);
  EXPECT_NEAR(tan(Interval{-1, 1}).hi, std::tan(1), 1e-14);
  EXPECT_EQ(sin(Interval{1e17, 1e17 + 16}).lo, -1);
}

TEST(Interval, DomainFaultsSetTheNanFlag) {
  EXPECT_TRUE(sqrt(Interval{-1, 4}).may_be_nan);
  EXPECT_EQ(sqrt(Interval{-1, 4}).lo, 0);
  EXPECT_TRUE(log(Interval{-2, -1}).may_be_nan);
  EXPECT_TRUE(asin(Interval{0, 1.5}).may_be_nan);
  EXPECT_TRUE(divide(Interval{0, 1}, Interval{0, 1}).may_be_nan);
  EXPECT_FALSE(divide(Interval{1, 2}, Interval{0, 1}).may_be_nan);
  EXPECT_TRUE(power(Interval{-1, 1}, Interval{0.5, 0.5}).may_be_nan);
  EXPECT_FALSE(power(Interval{-1, 1}, Interval{3, 3}).may_be_nan);
  EXPECT_TRUE(sin(Interval{0, kInfinity}).may_be_nan);
  EXPECT_TRUE((Interval{0, 1} * Interval{0, kInfinity}).may_be_nan);
  EXPECT_TRUE((Interval{0, kInfinity} - Interval{0, kInfinity}).may_be_nan);
}

TEST(Interval, StaysTightWhereItCan) {
  const Interval sum = Interval{0.5, 0.75} + Interval{0.25, 1};
  EXPECT_EQ(sum.lo, 0.75);
  EXPECT_EQ(sum.hi, 1.75);
  const Interval sq = square(Interval{-3, 2});
  EXPECT_EQ(sq.lo, 0);
  EXPECT_EQ(sq.hi, next_up(9));
  const Interval quotient = divide(Interval{1, 2}, Interval{4, 8});
  EXPECT_NEAR(quotient.lo, 0.125, 1e-16);
  EXPECT_NEAR(quotient.hi, 0.5, 1e-15);
  EXPECT_EQ(divide(Interval{1, 1}, Interval{0, 2}).lo, next_down(0.5));
}

}  // namespace
}  // namespace unsliver::geom
