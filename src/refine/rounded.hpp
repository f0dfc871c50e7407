/// \file
/// Doubles kept as floats, on the safe side.
#pragma once

#include <cmath>
#include <limits>

namespace unsliver::refine {

inline float rounded_down(double x) {
  const float f = static_cast<float>(x);
  return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
inline float rounded_up(double x) { return -rounded_down(-x); }
inline float rounded_towards_zero(double x) { return x < 0 ? -rounded_down(-x) : rounded_down(x); }

}  // namespace unsliver::refine
