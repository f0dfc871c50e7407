#include "geom/dual.hpp"

#include <algorithm>
#include <cmath>

namespace unsliver::geom {
namespace {

constexpr Interval kOne{1, 1};
constexpr Interval kUnitBall{-1, 1};
constexpr Interval kLn10{2.302585092994045, 2.302585092994046};

// Errors of one operation in units of the last place of its result.
constexpr double kExact = 0;
constexpr double kRounded = 1;

double times_up(double a, double b) { return a == 0 || b == 0 ? 0 : next_up(a * b); }

/// One operation's own rounding error; the smallest double covers underflow.
double own_error(const Interval& value, double ulps) {
  if (ulps == kExact) return 0;
  return next_up(ulps * kEpsilon * value.magnitude()) + std::numeric_limits<double>::denorm_min();
}

bool is_zero(const Interval& a) { return a.lo == 0 && a.hi == 0 && !a.may_be_nan; }

/// outer * inner as the chain rule means it: a constant argument stays constant however steep the function.
Interval chained(const Interval& outer, const Interval& inner) {
  if (is_zero(inner)) return inner;
  const Interval r = outer * inner;
  return r.may_be_nan ? Interval::whole() : r;
}

/// The length of the longest gradient that the slopes allow.
double length_of(const std::array<Interval, 3>& slope) {
  double sum = 0;
  for (const Interval& s : slope) sum = next_up(sum + times_up(s.magnitude(), s.magnitude()));
  return next_up(std::sqrt(sum));
}

bool is_constant(const Dual& a) { return is_zero(a.slope[0]) && is_zero(a.slope[1]) && is_zero(a.slope[2]); }

/// The function of a value that may jump, or may be undefined, over the box.
Dual without_slopes(const Interval& value, const Dual& argument) {
  Dual r{value, argument.slope, is_constant(argument) ? 0 : kInfinity, kInfinity};
  for (Interval& s : r.slope)
    if (!is_zero(s)) s = Interval::whole();
  return r;
}

/// f(u) with f' over u.
Dual chain(const Dual& u, const Interval& value, const Interval& derivative, double ulps) {
  if (!value.is_bounded()) return without_slopes(value, u);
  Dual r{value, {}, times_up(derivative.magnitude(), u.steepness), 0};
  for (int k = 0; k < 3; ++k) r.slope[k] = chained(derivative, u.slope[k]);
  r.rounding = next_up(times_up(derivative.magnitude(), u.rounding) + own_error(value, ulps));
  return r;
}

/// The sum of two chains that lead to one value: f(u, v) with the partial derivatives of f.
Dual chain(const Dual& u, const Interval& by_u, const Dual& v, const Interval& by_v, const Interval& value,
           double ulps) {
  const Dual a = chain(u, value, by_u, ulps), b = chain(v, value, by_v, kExact);
  Dual r{value, {}, next_up(a.steepness + b.steepness), next_up(a.rounding + b.rounding)};
  for (int k = 0; k < 3; ++k) r.slope[k] = a.slope[k] + b.slope[k];
  for (Interval& s : r.slope)
    if (s.may_be_nan) s = Interval::whole();
  r.steepness = std::min(r.steepness, length_of(r.slope));
  return r;
}

/// A function that is constant between jumps.
Dual step(const Dual& u, const Interval& value) {
  if (value.is_point()) return {value, {}, 0, 0};
  return without_slopes(value, u);
}

Dual step(const Dual& u, const Dual& v, const Interval& value) { return step(hull(u, v), value); }

Interval times(double factor, const Interval& a) { return Interval::point(factor) * a; }

Interval reciprocal(const Interval& a) { return divide(kOne, a); }

/// A Lipschitz constant of the map from space to the terms: no linear map is longer than the geometric mean
/// of its largest row sum and its largest column sum. 1 for (x - a, y - b, z - c).
double steepness_of_map(std::span<const Dual> terms) {
  double row_sum = 0;
  std::array<double, 3> column_sums{};
  for (const Dual& t : terms) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      sum = next_up(sum + t.slope[k].magnitude());
      column_sums[k] = next_up(column_sums[k] + t.slope[k].magnitude());
    }
    row_sum = std::max(row_sum, sum);
  }
  const double column_sum = *std::max_element(column_sums.begin(), column_sums.end());
  return next_up(std::sqrt(times_up(row_sum, column_sum)));
}

/// sqrt(1 - u^2), 0 at the least.
Interval cofunction(const Interval& u) { return sqrt(larger(kOne - square(u), {0, 0})); }

}  // namespace

Dual hull(const Dual& a, const Dual& b) {
  Dual r{hull(a.value, b.value), {}, std::max(a.steepness, b.steepness), std::max(a.rounding, b.rounding)};
  for (int k = 0; k < 3; ++k) r.slope[k] = hull(a.slope[k], b.slope[k]);
  return r;
}

Dual operator-(const Dual& a) { return chain(a, -a.value, {-1, -1}, kExact); }

Dual operator+(const Dual& a, const Dual& b) { return chain(a, kOne, b, kOne, a.value + b.value, kRounded); }

Dual operator-(const Dual& a, const Dual& b) {
  return chain(a, kOne, b, {-1, -1}, a.value - b.value, kRounded);
}

Dual operator*(const Dual& a, const Dual& b) {
  return chain(a, b.value, b, a.value, a.value * b.value, kRounded);
}

Dual divide(const Dual& a, const Dual& b) {
  const Interval value = divide(a.value, b.value);
  return chain(a, reciprocal(b.value), b, -divide(value, b.value), value, kRounded);
}

Dual square(const Dual& a) { return chain(a, square(a.value), times(2, a.value), kRounded); }

Dual power_int(const Dual& a, int n) {
  // Repeated squaring: every multiplication's relative error is raised by at most the factor that is left.
  const double ulps = 2.0 * std::abs(n);
  return chain(a, power_int(a.value, n), times(n, power_int(a.value, n - 1)), ulps);
}

Dual power(const Dual& a, const Dual& b) {
  const Interval value = power(a.value, b.value);
  const Interval by_base = b.value * power(a.value, b.value - kOne);
  return chain(a, by_base, b, value * log(a.value), value, kLibmUlps);
}

Dual norm(std::span<const Dual> terms) {
  // The gradient of the norm is a unit vector, also in the limit at 0.
  Interval sum;
  for (const Dual& t : terms) sum = sum + square(t.value);
  const Interval length = sqrt(larger(sum, {0, 0}));
  const auto along = [&length](const Interval& term) {
    const Interval q = divide(term, length);
    return Interval{std::max(q.lo, -1.0), std::min(q.hi, 1.0)};
  };
  Dual r = chain(terms[0], length, along(terms[0].value), static_cast<double>(terms.size()) + 2);
  for (std::size_t i = 1; i < terms.size(); ++i) {
    r = chain(r, kOne, terms[i], along(terms[i].value), length, kExact);
  }
  r.steepness = std::min(r.steepness, steepness_of_map(terms));
  // Squares that underflow lose up to sqrt(smallest double) of length; a bound for any count in use.
  r.rounding = next_up(r.rounding + 1e-160);
  return r;
}

Dual abs(const Dual& a) {
  const Interval derivative = a.value.lo >= 0 ? kOne : a.value.hi <= 0 ? -kOne : kUnitBall;
  return chain(a, abs(a.value), derivative, kExact);
}

Dual sqrt(const Dual& a) {
  const Interval value = sqrt(a.value);
  return chain(a, value, times(0.5, reciprocal(value)), kRounded);
}

Dual cbrt(const Dual& a) {
  const Interval value = cbrt(a.value);
  return chain(a, value, reciprocal(times(3, square(value))), kLibmUlps);
}

Dual exp(const Dual& a) {
  const Interval value = exp(a.value);
  return chain(a, value, value, kLibmUlps);
}

Dual log(const Dual& a) { return chain(a, log(a.value), reciprocal(a.value), kLibmUlps); }

Dual log10(const Dual& a) { return chain(a, log10(a.value), reciprocal(a.value * kLn10), kLibmUlps); }

Dual sin(const Dual& a) { return chain(a, sin(a.value), cos(a.value), kLibmUlps); }

Dual cos(const Dual& a) { return chain(a, cos(a.value), -sin(a.value), kLibmUlps); }

Dual tan(const Dual& a) {
  const Interval value = tan(a.value);
  return chain(a, value, kOne + square(value), kLibmUlps);
}

Dual asin(const Dual& a) { return chain(a, asin(a.value), reciprocal(cofunction(a.value)), kLibmUlps); }

Dual acos(const Dual& a) { return chain(a, acos(a.value), -reciprocal(cofunction(a.value)), kLibmUlps); }

Dual atan(const Dual& a) { return chain(a, atan(a.value), reciprocal(kOne + square(a.value)), kLibmUlps); }

Dual atan2(const Dual& y, const Dual& x) {
  const Interval value = atan2(y.value, x.value);
  const bool may_jump = y.value.lo <= 0 && y.value.hi >= 0 && x.value.lo <= 0;
  if (may_jump) return without_slopes(value, hull(y, x));
  const Interval length_sq = square(x.value) + square(y.value);
  return chain(y, divide(x.value, length_sq), x, -divide(y.value, length_sq), value, kLibmUlps);
}

Dual sinh(const Dual& a) { return chain(a, sinh(a.value), cosh(a.value), kLibmUlps); }

Dual cosh(const Dual& a) { return chain(a, cosh(a.value), sinh(a.value), kLibmUlps); }

Dual tanh(const Dual& a) {
  const Interval value = tanh(a.value);
  return chain(a, value, larger(kOne - square(value), {0, 0}), kLibmUlps);
}

Dual floor(const Dual& a) { return step(a, floor(a.value)); }
Dual ceil(const Dual& a) { return step(a, ceil(a.value)); }
Dual sign(const Dual& a) { return step(a, sign(a.value)); }

Dual smaller(const Dual& a, const Dual& b) {
  Dual r = a.value.hi < b.value.lo ? a : b.value.hi < a.value.lo ? b : hull(a, b);
  r.value = smaller(a.value, b.value);
  return r;
}

Dual larger(const Dual& a, const Dual& b) {
  Dual r = a.value.lo > b.value.hi ? a : b.value.lo > a.value.hi ? b : hull(a, b);
  r.value = larger(a.value, b.value);
  return r;
}

Dual less(const Dual& a, const Dual& b) { return step(a, b, less(a.value, b.value)); }

Dual less_equal(const Dual& a, const Dual& b) { return step(a, b, less_equal(a.value, b.value)); }

Dual select(const Dual& condition, const Dual& yes, const Dual& no) {
  const Interval& c = condition.value;
  Dual r = c.lo > 0 || c.hi < 0 ? yes : is_zero(c) ? no : hull(yes, no);
  r.value = select(c, yes.value, no.value);
  return is_zero(c) || c.lo > 0 || c.hi < 0 ? r : without_slopes(r.value, hull(condition, r));
}

}  // namespace unsliver::geom
