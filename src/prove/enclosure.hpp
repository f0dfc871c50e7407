/// \file
/// Real numbers enclosed between exact binary fractions, in integer arithmetic.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include "prove/fraction.hpp"

namespace unsliver::prover {

/// lo <= x <= hi, both multiples of 2^-36. Every operation rounds outwards, so that results enclose what
/// exact operands would give. Requires |x| < 2^25.
class Enclosure {
 public:
  using Raw = std::int64_t;
  static constexpr int kBits = 36;

  constexpr Enclosure() = default;
  constexpr Enclosure(int integer)
      : lo_(Raw(integer) << kBits), hi_(lo_) {}  // NOLINT: a number is its enclosure
  Enclosure(const Fraction& f);                  // NOLINT
  static constexpr Enclosure between(Raw lo, Raw hi) { return Enclosure(lo, hi); }
  /// From the least of a to the greatest of b.
  static constexpr Enclosure span(const Enclosure& a, const Enclosure& b) { return Enclosure(a.lo_, b.hi_); }

  constexpr Raw lo() const { return lo_; }
  constexpr Raw hi() const { return hi_; }
  constexpr Raw width() const { return hi_ - lo_; }
  constexpr bool is_certainly_below(const Enclosure& other) const { return hi_ < other.lo_; }
  constexpr bool is_certainly_positive() const { return lo_ > 0; }

  friend constexpr Enclosure operator-(const Enclosure& a) { return Enclosure(-a.hi_, -a.lo_); }
  friend constexpr Enclosure operator+(const Enclosure& a, const Enclosure& b) {
    return Enclosure(checked(Int128(a.lo_) + b.lo_), checked(Int128(a.hi_) + b.hi_));
  }
  friend constexpr Enclosure operator-(const Enclosure& a, const Enclosure& b) { return a + -b; }
  friend constexpr Enclosure operator*(const Enclosure& a, const Enclosure& b) {
    const Int128 p = Int128(a.lo_) * b.lo_, q = Int128(a.lo_) * b.hi_, r = Int128(a.hi_) * b.lo_,
                 s = Int128(a.hi_) * b.hi_;
    return Enclosure(floor_shift(least(least(p, q), least(r, s))),
                     ceil_shift(greatest(greatest(p, q), greatest(r, s))));
  }
  /// Requires that b does not hold zero.
  friend Enclosure operator/(const Enclosure& a, const Enclosure& b);

  /// a / b rounded down, b != 0.
  static Raw floor_quotient(Int128 a, Int128 b);
  static Raw ceil_quotient(Int128 a, Int128 b) { return -floor_quotient(-a, b); }

 private:
  constexpr Enclosure(Raw lo, Raw hi) : lo_(lo), hi_(hi) {}
  static constexpr Int128 least(Int128 a, Int128 b) { return a < b ? a : b; }
  static constexpr Int128 greatest(Int128 a, Int128 b) { return a < b ? b : a; }
  static constexpr Raw floor_shift(Int128 x) { return checked(x >> kBits); }
  static constexpr Raw ceil_shift(Int128 x) { return checked(-((-x) >> kBits)); }
  /// \throws std::range_error
  static constexpr Raw checked(Int128 x) {
    constexpr Int128 kMost = Int128(1) << (25 + kBits);
    if (x >= kMost || x <= -kMost) throw std::range_error("an enclosure left its range");
    return Raw(x);
  }

  Raw lo_ = 0, hi_ = 0;
};

/// Requires x >= 0.
Enclosure square_root(const Enclosure& x);
/// x^2, never negative.
Enclosure square(const Enclosure& x);
/// cos of degrees in [0, 180], given in thousandths.
Enclosure cosine_of_millidegrees(int millidegrees);
/// The middle, for people.
double middle(const Enclosure& x);
std::string text(const Enclosure& x);

}  // namespace unsliver::prover
