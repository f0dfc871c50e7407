#include "geom/interval.hpp"

#include <algorithm>
#include <numbers>

namespace unsliver::geom {
namespace {

constexpr double kPi = std::numbers::pi;

double libm_down(double v) {
  return std::isinf(v) ? next_down(v) : next_down(v - kLibmUlps * kEpsilon * std::fabs(v));
}
double libm_up(double v) { return -libm_down(-v); }

bool both_nan_free(const Interval& a, const Interval& b) { return !a.may_be_nan && !b.may_be_nan; }
bool has_zero(const Interval& a) { return a.lo <= 0 && a.hi >= 0; }

/// The hull of the products or quotients of ends; an undefined one (0 * inf, inf / inf) stands for 0, which
/// together with its neighbours spans every finite value that it can hide.
Interval hull_of_ends(std::initializer_list<double> ends) {
  Interval r{kInfinity, -kInfinity};
  for (double v : ends) {
    const double w = std::isnan(v) ? 0.0 : v;
    r.lo = std::min(r.lo, w);
    r.hi = std::max(r.hi, w);
  }
  return r;
}

Interval rounded_outward(const Interval& a) { return {next_down(a.lo), next_up(a.hi), a.may_be_nan}; }

/// The sum rounded down, exactly: Knuth's two-sum tells on which side of the rounded sum the true one lies.
double sum_down(double a, double b) {
  const double s = a + b;
  if (std::isnan(s)) return -kInfinity;
  const double b_part = s - a;
  const double error = (a - (s - b_part)) + (b - b_part);
  return error >= 0 ? s : next_down(s);
}
double sum_up(double a, double b) { return -sum_down(-a, -b); }

template <class F>
Interval increasing(F f, const Interval& a) {
  return {libm_down(f(a.lo)), libm_up(f(a.hi)), a.may_be_nan};
}

Interval clipped(const Interval& a, double lo, double hi) {
  return {std::clamp(a.lo, lo, hi), std::clamp(a.hi, lo, hi), a.may_be_nan};
}

/// Cuts the argument to the domain [lo, hi] of a function; what is cut away would be NaN.
/// Requires that the two meet.
Interval within_domain(const Interval& a, double lo, double hi) {
  return {std::max(a.lo, lo), std::min(a.hi, hi), a.may_be_nan || a.lo < lo || a.hi > hi};
}
bool misses(const Interval& a, double lo, double hi) { return a.hi < lo || a.lo > hi; }

/// False only if no offset + k * period, k an integer, lies in a. The slack covers the rounding of offset,
/// period and the two quotients; infinite ends give true.
bool may_hold_multiple(const Interval& a, double offset, double period) {
  const double first = (a.lo - offset) / period, last = (a.hi - offset) / period;
  const double slack = 8 * kEpsilon * (1 + std::fabs(first) + std::fabs(last));
  return !(std::floor(last + slack) < std::ceil(first - slack));
}

/// sin or cos, whose maxima lie at `top` + 2 pi k and whose minima lie at `top` + pi + 2 pi k.
template <class F>
Interval wave(F f, const Interval& a, double top) {
  const bool nan = a.may_be_nan || a.has_infinity();
  if (!(a.hi - a.lo < 2 * kPi)) return {-1, 1, nan};
  const double u = f(a.lo), v = f(a.hi);
  const double lo = may_hold_multiple(a, top + kPi, 2 * kPi) ? -1 : libm_down(std::min(u, v));
  const double hi = may_hold_multiple(a, top, 2 * kPi) ? 1 : libm_up(std::max(u, v));
  return clipped({lo, hi, nan}, -1, 1);
}

/// a^n for a >= 0, n >= 1, by the same multiplications as the double version.
Interval power_of_nonnegative(Interval a, int n) {
  Interval result{1, 1, a.may_be_nan};
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) result = result * a;
    if (n > 1) a = square(a);
  }
  return {std::max(result.lo, 0.0), result.hi, result.may_be_nan};
}

Interval positive_power_int(const Interval& a, int n) {
  if (n % 2 == 0) return power_of_nonnegative(abs(a), n);
  // Odd powers are odd functions, in floating point too.
  const auto end = [n](double v) {
    const Interval p = power_of_nonnegative(Interval::point(std::fabs(v)), n);
    return v < 0 ? -p : p;
  };
  return {end(a.lo).lo, end(a.hi).hi, a.may_be_nan};
}

/// u^v is monotone in each argument alone where u >= 0, so its extremes lie at corners. Zeros count as +0.
Interval power_of_nonnegative(const Interval& a, const Interval& b) {
  const double low = a.lo + 0.0, high = a.hi + 0.0;
  const Interval ends =
      hull_of_ends({std::pow(low, b.lo), std::pow(low, b.hi), std::pow(high, b.lo), std::pow(high, b.hi)});
  return {std::max(libm_down(ends.lo), 0.0), libm_up(ends.hi), !both_nan_free(a, b)};
}

bool is_integer(double v) { return std::isfinite(v) && v == std::floor(v); }

}  // namespace

Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi), !both_nan_free(a, b)};
}

Interval operator-(const Interval& a) { return {-a.hi, -a.lo, a.may_be_nan}; }

Interval operator+(const Interval& a, const Interval& b) {
  const bool clash = (a.hi == kInfinity && b.lo == -kInfinity) || (a.lo == -kInfinity && b.hi == kInfinity);
  return {sum_down(a.lo, b.lo), sum_up(a.hi, b.hi), clash || !both_nan_free(a, b)};
}

Interval operator-(const Interval& a, const Interval& b) { return a + -b; }

Interval operator*(const Interval& a, const Interval& b) {
  const bool clash = (has_zero(a) && b.has_infinity()) || (a.has_infinity() && has_zero(b));
  const bool nan = clash || !both_nan_free(a, b);
  if ((a.lo == 0 && a.hi == 0) || (b.lo == 0 && b.hi == 0)) return {0, 0, nan};
  Interval r = rounded_outward(hull_of_ends({a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi}));
  // Signs are exact: a product of nonnegative factors is never below 0.
  if ((a.lo >= 0 && b.lo >= 0) || (a.hi <= 0 && b.hi <= 0)) r.lo = std::max(r.lo, 0.0);
  if ((a.lo >= 0 && b.hi <= 0) || (a.hi <= 0 && b.lo >= 0)) r.hi = std::min(r.hi, 0.0);
  r.may_be_nan = nan;
  return r;
}

Interval divide(const Interval& a, const Interval& b) {
  const bool clash = (has_zero(a) && has_zero(b)) || (a.has_infinity() && b.has_infinity());
  const bool nan = clash || !both_nan_free(a, b);
  if (a.has_infinity() && b.has_infinity()) return Interval::whole(nan);
  if (b.lo < 0 && b.hi >= 0) return Interval::whole(nan);
  if (b.hi == 0) return a.lo > 0 ? Interval{kInfinity, kInfinity, nan} : Interval::whole(nan);
  Interval r = b.lo == 0 ? Interval{a.lo >= 0 ? a.lo / b.hi : -kInfinity, a.hi <= 0 ? a.hi / b.hi : kInfinity}
                         : hull_of_ends({a.lo / b.lo, a.lo / b.hi, a.hi / b.lo, a.hi / b.hi});
  r = rounded_outward(r);
  if ((a.lo >= 0 && b.lo >= 0) || (a.hi <= 0 && b.hi < 0)) r.lo = std::max(r.lo, 0.0);
  if ((a.lo >= 0 && b.hi < 0) || (a.hi <= 0 && b.lo >= 0)) r.hi = std::min(r.hi, 0.0);
  r.may_be_nan = nan;
  return r;
}

Interval square(const Interval& a) {
  const Interval m = abs(a);
  return {std::max(next_down(m.lo * m.lo), 0.0), m.hi == 0 ? 0 : next_up(m.hi * m.hi), a.may_be_nan};
}

Interval power_int(const Interval& a, int n) {
  if (n == 0) return {1, 1};
  if (n > 0) return positive_power_int(a, n);
  return divide({1, 1}, positive_power_int(a, -n));
}

Interval power(const Interval& a, const Interval& b) {
  if (a.lo >= 0) return power_of_nonnegative(a, b);
  const Interval size = power_of_nonnegative(abs(a), b);
  if (b.is_point() && is_integer(b.lo)) {
    if (std::fmod(b.lo, 2) == 0) return size;
    if (a.hi < 0) return -size;
    const bool inverse = b.lo < 0;
    if (inverse) return Interval::whole(a.may_be_nan);
    const double low = libm_up(std::pow(-a.lo, b.lo)), high = libm_up(std::pow(a.hi, b.lo));
    return {-low, high, a.may_be_nan};
  }
  return {-size.hi, size.hi, true};
}

Interval norm(std::span<const Interval> terms) {
  Interval sum;
  for (const Interval& t : terms) sum = sum + square(t);
  return sqrt({std::max(sum.lo, 0.0), sum.hi, sum.may_be_nan});
}

Interval abs(const Interval& a) {
  if (a.lo >= 0) return a;
  if (a.hi <= 0) return -a;
  return {0, a.magnitude(), a.may_be_nan};
}

Interval sqrt(const Interval& a) {
  if (misses(a, 0, kInfinity)) return Interval::whole(true);
  const Interval u = within_domain(a, 0, kInfinity);
  const auto widened = [](double v, double (*widen)(double)) { return v == 0 ? 0.0 : widen(std::sqrt(v)); };
  return {std::max(widened(u.lo, next_down), 0.0), widened(u.hi, next_up), u.may_be_nan};
}

Interval cbrt(const Interval& a) {
  return increasing([](double v) { return std::cbrt(v); }, a);
}

Interval exp(const Interval& a) {
  return clipped(increasing([](double v) { return std::exp(v); }, a), 0, kInfinity);
}

Interval log(const Interval& a) {
  if (misses(a, 0, kInfinity)) return Interval::whole(true);
  return increasing([](double v) { return std::log(v); }, within_domain(a, 0, kInfinity));
}

Interval log10(const Interval& a) {
  if (misses(a, 0, kInfinity)) return Interval::whole(true);
  return increasing([](double v) { return std::log10(v); }, within_domain(a, 0, kInfinity));
}

Interval sin(const Interval& a) {
  return wave([](double v) { return std::sin(v); }, a, kPi / 2);
}

Interval cos(const Interval& a) {
  return wave([](double v) { return std::cos(v); }, a, 0);
}

Interval tan(const Interval& a) {
  if (may_hold_multiple(a, kPi / 2, kPi)) return Interval::whole(a.may_be_nan || a.has_infinity());
  return increasing([](double v) { return std::tan(v); }, a);
}

Interval asin(const Interval& a) {
  if (misses(a, -1, 1)) return Interval::whole(true);
  return increasing([](double v) { return std::asin(v); }, within_domain(a, -1, 1));
}

Interval acos(const Interval& a) {
  if (misses(a, -1, 1)) return Interval::whole(true);
  const Interval u = within_domain(a, -1, 1);
  return {std::max(libm_down(std::acos(u.hi)), 0.0), libm_up(std::acos(u.lo)), u.may_be_nan};
}

Interval atan(const Interval& a) {
  return increasing([](double v) { return std::atan(v); }, a);
}

Interval atan2(const Interval& y, const Interval& x) {
  const bool nan = !both_nan_free(y, x);
  if (has_zero(y) && x.lo <= 0) return {-libm_up(kPi), libm_up(kPi), nan};
  // The angle over a convex set that does not hold the origin: extremes at corners.
  const Interval ends = hull_of_ends(
      {std::atan2(y.lo, x.lo), std::atan2(y.lo, x.hi), std::atan2(y.hi, x.lo), std::atan2(y.hi, x.hi)});
  return {libm_down(ends.lo), libm_up(ends.hi), nan};
}

Interval sinh(const Interval& a) {
  return increasing([](double v) { return std::sinh(v); }, a);
}

Interval cosh(const Interval& a) {
  return clipped(increasing([](double v) { return std::cosh(v); }, abs(a)), 1, kInfinity);
}

Interval tanh(const Interval& a) {
  return clipped(increasing([](double v) { return std::tanh(v); }, a), -1, 1);
}

Interval floor(const Interval& a) { return {std::floor(a.lo), std::floor(a.hi), a.may_be_nan}; }

Interval ceil(const Interval& a) { return {std::ceil(a.lo), std::ceil(a.hi), a.may_be_nan}; }

Interval sign(const Interval& a) {
  const auto of = [](double v) { return static_cast<double>((v > 0) - (v < 0)); };
  return {of(a.lo), of(a.hi), a.may_be_nan};
}

Interval smaller(const Interval& a, const Interval& b) {
  return {std::min(a.lo, b.lo), std::min(a.hi, b.hi), !both_nan_free(a, b)};
}

Interval larger(const Interval& a, const Interval& b) {
  return {std::max(a.lo, b.lo), std::max(a.hi, b.hi), !both_nan_free(a, b)};
}

Interval less(const Interval& a, const Interval& b) {
  const bool surely = a.hi < b.lo, never = a.lo >= b.hi;
  return {surely ? 1.0 : 0.0, never ? 0.0 : 1.0, !both_nan_free(a, b)};
}

Interval less_equal(const Interval& a, const Interval& b) {
  const bool surely = a.hi <= b.lo, never = a.lo > b.hi;
  return {surely ? 1.0 : 0.0, never ? 0.0 : 1.0, !both_nan_free(a, b)};
}

Interval select(const Interval& condition, const Interval& yes, const Interval& no) {
  const bool nan = condition.may_be_nan;
  if (!has_zero(condition)) return {yes.lo, yes.hi, yes.may_be_nan || nan};
  if (condition.lo == 0 && condition.hi == 0) return {no.lo, no.hi, no.may_be_nan || nan};
  Interval r = hull(yes, no);
  r.may_be_nan = r.may_be_nan || nan;
  return r;
}

}  // namespace unsliver::geom
