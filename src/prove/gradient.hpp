/// \file
/// Enclosures of a function over a box together with those of its three partial derivatives.
#pragma once

#include <array>

#include "prove/enclosure.hpp"

namespace unsliver::prover {

struct Gradient {
  Enclosure value;
  std::array<Enclosure, 3> slope{};

  Gradient(int constant) : value(constant) {}  // NOLINT: a constant has no slope
  Gradient(const Enclosure& v, const std::array<Enclosure, 3>& s) : value(v), slope(s) {}
  /// The coordinate along an axis.
  static Gradient coordinate(const Enclosure& range, int axis) {
    Gradient g(range, {});
    g.slope[std::size_t(axis)] = 1;
    return g;
  }

  friend Gradient operator-(const Gradient& a) { return Gradient(0) - a; }
  friend Gradient operator+(const Gradient& a, const Gradient& b) {
    return combine(a.value + b.value, [&](std::size_t i) { return a.slope[i] + b.slope[i]; });
  }
  friend Gradient operator-(const Gradient& a, const Gradient& b) {
    return combine(a.value - b.value, [&](std::size_t i) { return a.slope[i] - b.slope[i]; });
  }
  friend Gradient operator*(const Gradient& a, const Gradient& b) {
    return combine(a.value * b.value,
                   [&](std::size_t i) { return a.slope[i] * b.value + a.value * b.slope[i]; });
  }
  /// Requires that b.value does not hold zero.
  friend Gradient operator/(const Gradient& a, const Gradient& b) {
    const Enclosure quotient = a.value / b.value;
    return combine(quotient, [&](std::size_t i) { return (a.slope[i] - quotient * b.slope[i]) / b.value; });
  }

 private:
  template <class Slope>
  static Gradient combine(const Enclosure& value, const Slope& slope) {
    return {value, {slope(0), slope(1), slope(2)}};
  }
};

/// x |x|
inline Gradient signed_square(const Gradient& x) {
  const auto signed_square_of = [](Enclosure::Raw r) {
    const Enclosure e = Enclosure::between(r, r);
    return r < 0 ? -(e * e) : e * e;
  };
  const Enclosure value = Enclosure::span(signed_square_of(x.value.lo()), signed_square_of(x.value.hi()));
  const Enclosure::Raw lo = x.value.lo(), hi = x.value.hi();
  const Enclosure::Raw least = lo > 0 ? lo : hi < 0 ? -hi : 0, most = hi > -lo ? hi : -lo;
  const Enclosure twice_size = Enclosure(2) * Enclosure::between(least, most);
  return {value, {twice_size * x.slope[0], twice_size * x.slope[1], twice_size * x.slope[2]}};
}

}  // namespace unsliver::prover
