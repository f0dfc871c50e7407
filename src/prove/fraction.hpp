/// \file
/// Exact fractions of small integers.
#pragma once

#include <compare>
#include <cstdint>
#include <numeric>
#include <string>

namespace unsliver::prover {

__extension__ typedef __int128 Int128;

/// num / den, den > 0, not reduced. Compared exactly.
struct Fraction {
  std::int64_t num = 0, den = 1;

  friend std::strong_ordering operator<=>(const Fraction& a, const Fraction& b) {
    return Int128(a.num) * b.den <=> Int128(b.num) * a.den;
  }
  friend bool operator==(const Fraction& a, const Fraction& b) { return (a <=> b) == 0; }
};

/// "5/4", "3"
inline std::string text(const Fraction& f) {
  const std::int64_t divisor = std::gcd(f.num, f.den);
  const std::string num = std::to_string(f.num / divisor);
  return f.den == divisor ? num : num + "/" + std::to_string(f.den / divisor);
}

}  // namespace unsliver::prover
