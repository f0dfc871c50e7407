/// \file
/// Random numbers, boxes and formulas that are the same on every platform.
#pragma once

#include <random>
#include <string>

#include "unsliver/types.hpp"

namespace unsliver::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t below(std::uint64_t n) { return engine_() % n; }
  double uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  Vec3 in(const Box3& b) {
    return {uniform(b.lo.x, b.hi.x), uniform(b.lo.y, b.hi.y), uniform(b.lo.z, b.hi.z)};
  }
  /// A box in [-r, r]^3 of any scale down to 2^-40 r, often with a corner at 0.
  Box3 box(double r) {
    Box3 b;
    const Vec3 p = in({{-r, -r, -r}, {r, r, r}});
    const double side = r * std::ldexp(1.0, -static_cast<int>(below(40)));
    b.extend(below(4) == 0 ? Vec3{} : p);
    b.extend(b.lo + Vec3{uniform(0, side), uniform(0, side), uniform(0, side)});
    return b;
  }
  /// A point of the box: a corner, or anywhere.
  Vec3 point_of(const Box3& b) {
    if (below(3) != 0) return in(b);
    return {below(2) ? b.lo.x : b.hi.x, below(2) ? b.lo.y : b.hi.y, below(2) ? b.lo.z : b.hi.z};
  }

 private:
  std::mt19937_64 engine_;
};

/// A syntactically valid formula with about `size` operations.
inline std::string random_formula(Random& random, int size) {
  static constexpr const char* kLeaves[] = {"x", "y", "z", "0.5", "2", "pi", "x", "1e-3", "-1.25", "z"};
  static constexpr const char* kUnary[] = {"abs",  "sqrt",  "cbrt", "exp",  "log",  "log10", "sin",
                                           "cos",  "tan",   "asin", "acos", "atan", "sinh",  "cosh",
                                           "tanh", "floor", "ceil", "sign", "-"};
  static constexpr const char* kInfix[] = {"+", "-", "*", "/", "+", "*", "<", "<=", ">", ">="};
  static constexpr const char* kBinary[] = {"min", "max", "atan2", "hypot"};
  static constexpr const char* kPowers[] = {"2", "3", "-1", "-2", "0.5", "1.5", "7", "-3", "100", "0"};
  if (size <= 0) return kLeaves[random.below(std::size(kLeaves))];
  const auto part = [&](int s) { return random_formula(random, s); };
  const int left = static_cast<int>(random.below(static_cast<std::uint64_t>(size))), right = size - 1 - left;
  switch (random.below(9)) {
    case 0:
    case 1:
      return std::string(kUnary[random.below(std::size(kUnary))]) + "(" + part(size - 1) + ")";
    case 2:
      return "(" + part(size - 1) + ")^" + kPowers[random.below(std::size(kPowers))];
    case 3:
      return std::string(kBinary[random.below(4)]) + "(" + part(left) + "," + part(right) + ")";
    case 4:
      return "(" + part(left) + ")^(" + part(right) + ")";
    case 5:
      return "(" + part(0) + "<" + part(0) + "?" + part(left) + ":" + part(right) + ")";
    case 6:
      return "sqrt((" + part(left) + ")^2+(" + part(right) + ")^2)";
    default:
      return "(" + part(left) + ")" + kInfix[random.below(std::size(kInfix))] + "(" + part(right) + ")";
  }
}

}  // namespace unsliver::test
