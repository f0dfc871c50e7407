/// \file
/// The judge's own exact numbers. Nothing here is shared with the generator.
#pragma once

#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace unsliver::verifier {

namespace mp = boost::multiprecision;

__extension__ typedef __int128 Int128;
using BigInt = mp::number<mp::cpp_int_backend<>, mp::et_off>;

/// The three components of a vector of numbers T.
template <class T>
using Row = std::array<T, 3>;

/// Half the distance from 1 to the next double: the relative error of one rounding.
inline constexpr double kRoundoff = 0x1p-53;

/// x = mantissa * 2^exponent with an odd mantissa; zero is 0 * 2^0.
struct Dyadic {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

/// Requires: x is finite. Every double is such a number, exactly.
inline Dyadic decompose(double x) {
  if (x == 0) return {};
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {mantissa / (std::int64_t{1} << zeros), exponent - 53 + zeros};
}

/// x * 2^-exponent. Requires: that is an integer.
inline BigInt scaled(double x, int exponent) {
  const Dyadic d = decompose(x);
  return d.mantissa == 0 ? BigInt(0) : BigInt(d.mantissa) << (d.exponent - exponent);
}

template <class T>
int sign(const T& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

}  // namespace unsliver::verifier
