/// \file
/// Quality bounds as rationals of at most 20 bits.
#include <cassert>
#include <cstdint>

#include "exact/quality_signs.hpp"

namespace unsliver::exact {
namespace {

constexpr std::int64_t kLargest = (std::int64_t{1} << 20) - 1;

/// A request is a double that went through arithmetic of its own: a rational this near is what was meant.
constexpr double kNoise = 0x1p-48;

struct Fraction {
  std::int64_t num, den;
};

/// Below: the largest fraction of at most 20 bits not above x, but for noise; else the smallest not below.
/// Requires: 0 <= x < 2^20 - 1. By descent in the Stern-Brocot tree.
Fraction nearest_fraction(double x, bool below) {
  assert(0 <= x && x < static_cast<double>(kLargest));
  if (x == 0) return {0, 1};
  const double target = below ? x * (1 + kNoise) : x * (1 - kNoise);
  Fraction low = {0, 1}, high = {1, 0};
  while (low.num + high.num <= kLargest && low.den + high.den <= kLargest) {
    const Fraction middle = {low.num + high.num, low.den + high.den};
    const double num = static_cast<double>(middle.num), at = target * static_cast<double>(middle.den);
    (num < at || (below && num == at) ? low : high) = middle;
  }
  return below ? low : high;
}

/// sin^2 by its Taylor series: the same bits everywhere, unlike a libm's. Requires: 0 <= degrees <= 45.
double sin_sq(double degrees) {
  const double x = degrees * 0.017453292519943295769, x_sq = x * x;
  double term = x, sum = x;
  for (int k = 2; k < 20; k += 2) {
    term *= -x_sq / (k * (k + 1));
    sum += term;
  }
  return sum * sum;
}

/// cos^2. Requires: 0 < degrees <= 90.
double cos_sq(double degrees) { return degrees <= 45 ? 1 - sin_sq(degrees) : sin_sq(90 - degrees); }

}  // namespace

CosBound cos_bound(double degrees, bool is_min) {
  assert(0 < degrees && degrees < 180);
  const bool acute = degrees < 90;
  // An angle rounded down has its cosine rounded up, and the square of a negative cosine down.
  const bool below = is_min != acute;
  const Fraction f = nearest_fraction(cos_sq(acute ? degrees : 180 - degrees), below);
  return {f.num == 0 ? 0 : acute ? 1 : -1, f.num, f.den};
}

RatioBound ratio_bound(double ratio) {
  assert(ratio > 0);
  const Fraction f = nearest_fraction(ratio * ratio, false);
  return {f.num, f.den};
}

}  // namespace unsliver::exact
