// The arithmetic that the claims are decided in.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "prove/decimals.hpp"
#include "prove/gradient.hpp"
#include "prove/surd.hpp"
#include "unsliver/error.hpp"
#include "unsliver/prove.hpp"

namespace unsliver::prover {
namespace {

bool encloses(const Enclosure& x, long double value) {
  const long double scaled = std::ldexp(value, Enclosure::kBits);
  return (long double)x.lo() - 1e-6L <= scaled && scaled <= (long double)x.hi() + 1e-6L;
}

TEST(Enclosure, HoldsTheResultsOfRandomOperations) {
  std::mt19937_64 random(1);
  const auto fraction = [&] {
    return Fraction{std::int64_t(random() % 20'001) - 10'000, std::int64_t(random() % 999) + 1};
  };
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const Fraction f = fraction(), g = fraction();
    const Enclosure x(f), y(g);
    const long double p = (long double)f.num / f.den, q = (long double)g.num / g.den;
    EXPECT_TRUE(encloses(x + y, p + q));
    EXPECT_TRUE(encloses(x - y, p - q));
    EXPECT_TRUE(std::abs(p * q) > 1e7 || encloses(x * y, p * q));
    EXPECT_TRUE(std::abs(q) < 0.01 || encloses(x / y, p / q));
    EXPECT_TRUE(std::abs(p) > 1000 || encloses(square_root(square(x)), std::abs(p)));
    EXPECT_LE((x + y).width(), 4);
  }
}

TEST(Enclosure, RefusesToLeaveItsRange) {
  const Enclosure large = 1 << 20;
  EXPECT_THROW(large * large, std::range_error);
}

TEST(Enclosure, Cosines) {
  for (int millidegrees = 0; millidegrees <= 180'000; millidegrees += 777) {
    const Enclosure c = cosine_of_millidegrees(millidegrees);
    EXPECT_TRUE(encloses(c, std::cos(millidegrees / 180'000.0L * 3.14159265358979323846L))) << millidegrees;
    EXPECT_LT(middle(c) - std::ldexp(double(c.lo()), -Enclosure::kBits), 1e-8);
  }
}

TEST(Decimals, ExactAnglesPrintAsThemselvesOnly) {
  EXPECT_TRUE(prints_as(kAngle30, 30'000));
  EXPECT_FALSE(prints_as(kAngle30, 30'001));
  EXPECT_FALSE(prints_as(kAngle30, 29'999));
  EXPECT_TRUE(prints_as(kAngle135, 135'000));
  EXPECT_FALSE(prints_as(kAngle135, 134'999));
  EXPECT_TRUE(is_below(Enclosure(Fraction{3, 4}), 30'001));
  EXPECT_FALSE(is_below(Enclosure(Fraction{3, 4}), 29'999));
  EXPECT_TRUE(root_prints_as(Enclosure(2), 1'414));
  EXPECT_FALSE(root_prints_as(Enclosure(2), 1'412));
}

TEST(Surd, SignsAgreeWithDoubles) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    const int a = int(random() % 2001) - 1000, b = int(random() % 2001) - 1000;
    const double value = a + b * std::sqrt(6.0);
    EXPECT_EQ(Surd(a, b).sign(), (value > 0) - (value < 0)) << a << " " << b;
  }
  EXPECT_EQ(Surd(0, 0).sign(), 0);
  EXPECT_LT(Surd(-485, 198).sign(), 1);
  EXPECT_EQ(Surd(485, -198).sign(), 1);  // a convergent: 485^2 - 6 198^2 = 1
}

TEST(Surd, Enclosures) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 500; ++i) {
    const auto number = [&] { return int(random() % 2001) - 1000; };
    const SurdFraction f{Surd(number(), number()), Surd(1 + int(random() % 50), int(random() % 50))};
    const long double value =
        ((long double)middle(enclosure_of({f.num, 1}))) / (long double)middle(enclosure_of({f.den, 1}));
    EXPECT_NEAR(middle(enclosure_of(f)), double(value), 1e-6);
    EXPECT_LE(enclosure_of(f).width(), 2);
  }
}

TEST(Gradient, SlopesOfAQuotient) {
  const auto at = [](double x) {
    return Enclosure::between(Enclosure::Raw(std::ldexp(x, 36)), Enclosure::Raw(std::ldexp(x, 36)));
  };
  const Gradient x = Gradient::coordinate(at(1.5), 0), y = Gradient::coordinate(at(-2), 1);
  const Gradient f = signed_square(x * y) / (x + Gradient(3));  // -9 / 4.5
  EXPECT_NEAR(middle(f.value), -2, 1e-9);
  EXPECT_NEAR(middle(f.slope[0]), (2 * 3 * -2 + 2) / 4.5, 1e-9);
  EXPECT_NEAR(middle(f.slope[1]), 2 * 3 * 1.5 / 4.5, 1e-9);
  EXPECT_EQ(f.slope[2].lo(), 0);
  EXPECT_EQ(f.slope[2].hi(), 0);
}

TEST(Angle, OrderIsThatOfDegrees) {
  EXPECT_LT(kAngle30, kAngle45);
  EXPECT_LT(kAngle90, kAngle120);
  EXPECT_LT(kAngle120, kAngle135);
  EXPECT_EQ(Angle({6, 8}), kAngle30);
  EXPECT_EQ(text(kAngle135), "135");
}

TEST(Claims, AreListedOnceAndUnknownOnesRefused) {
  std::vector<std::string> ids;
  for (const Claim& claim : provable_claims()) {
    ids.push_back(claim.id);
    EXPECT_FALSE(claim.statement.empty());
  }
  EXPECT_GE(ids.size(), 18u);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
  EXPECT_THROW(decide_claim("lemma-99"), Error);
  const Proof proof = decide_claim("lemma-5");
  EXPECT_TRUE(proof.holds());
  EXPECT_TRUE(proof.is_as_recorded());
}

TEST(Claims, ADifferenceThatIsExplainedMustBeThere) {
  Proof proof;
  proof.parts = {{"a", "b", true, "docs/x.md"}};
  EXPECT_FALSE(proof.is_as_recorded());
  proof.parts = {{"a", "b", false, "docs/x.md"}};
  EXPECT_TRUE(proof.is_as_recorded());
  EXPECT_FALSE(proof.holds());
  proof.parts = {{"a", "b", false, ""}};
  EXPECT_FALSE(proof.is_as_recorded());
}

}  // namespace
}  // namespace unsliver::prover
