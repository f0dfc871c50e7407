/// \file
/// Closed intervals with outward rounding, for sound bounds over boxes.
///
/// Every function here keeps one promise: if each argument holds a value u (exact, or a double computed in
/// round-to-nearest), the result holds both the exact f(u) and the double that C++ computes for f(u).
/// + - * / and sqrt are correctly rounded by IEEE 754; the functions of libm are assumed to be within
/// kLibmUlps units in the last place.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>

namespace unsliver::geom {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
/// More than the largest error that the usual C libraries document for the functions used here.
inline constexpr double kLibmUlps = 8;

/// The next double above v; infinity and NaN stay. (std::nextafter, without the call.)
inline double next_up(double v) {
  if (!(v < kInfinity)) return v;
  if (v == 0) return std::numeric_limits<double>::denorm_min();
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(v) + (v > 0 ? 1 : -1));
}
inline double next_down(double v) { return -next_up(-v); }

/// The values in [lo, hi], and NaN too if may_be_nan. lo <= hi always; infinite ends are attainable values.
struct Interval {
  double lo = 0, hi = 0;
  bool may_be_nan = false;

  static Interval whole(bool may_be_nan = false) { return {-kInfinity, kInfinity, may_be_nan}; }
  /// A single value; NaN gives everything.
  static Interval point(double v) { return std::isnan(v) ? whole(true) : Interval{v, v}; }

  bool contains(double v) const { return std::isnan(v) ? may_be_nan : lo <= v && v <= hi; }
  bool is_point() const { return lo == hi && !may_be_nan; }
  bool is_bounded() const { return lo > -kInfinity && hi < kInfinity && !may_be_nan; }
  bool has_infinity() const { return lo == -kInfinity || hi == kInfinity; }
  /// The largest absolute value.
  double magnitude() const { return std::fmax(std::fabs(lo), std::fabs(hi)); }
};

Interval hull(const Interval& a, const Interval& b);

Interval operator-(const Interval& a);
Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator*(const Interval& a, const Interval& b);
/// A zero divisor counts as +0, as in `divide` for doubles.
Interval divide(const Interval& a, const Interval& b);
Interval square(const Interval& a);
/// a^n by repeated squaring, for the integer n of either sign.
Interval power_int(const Interval& a, int n);
Interval power(const Interval& a, const Interval& b);
/// The square root of the sum of squares.
Interval norm(std::span<const Interval> terms);

Interval abs(const Interval& a);
Interval sqrt(const Interval& a);
Interval cbrt(const Interval& a);
Interval exp(const Interval& a);
Interval log(const Interval& a);
Interval log10(const Interval& a);
Interval sin(const Interval& a);
Interval cos(const Interval& a);
Interval tan(const Interval& a);
Interval asin(const Interval& a);
Interval acos(const Interval& a);
Interval atan(const Interval& a);
/// Zeros count as +0; [-pi, pi] when the arguments may touch the branch cut.
Interval atan2(const Interval& y, const Interval& x);
Interval sinh(const Interval& a);
Interval cosh(const Interval& a);
Interval tanh(const Interval& a);
Interval floor(const Interval& a);
Interval ceil(const Interval& a);
/// -1, 0 or 1.
Interval sign(const Interval& a);

Interval smaller(const Interval& a, const Interval& b);
Interval larger(const Interval& a, const Interval& b);
/// 1 where a < b, 0 where a >= b.
Interval less(const Interval& a, const Interval& b);
Interval less_equal(const Interval& a, const Interval& b);
/// `yes` where the condition is not 0, `no` where it is 0.
Interval select(const Interval& condition, const Interval& yes, const Interval& no);

}  // namespace unsliver::geom
