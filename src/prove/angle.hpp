/// \file
/// Angles without transcendental functions.
#pragma once

#include <string>

#include "prove/fraction.hpp"

namespace unsliver::prover {

/// An angle in [0, 180] degrees as the fraction sign(cos) cos^2, which falls as the angle grows.
class Angle {
 public:
  constexpr explicit Angle(Fraction signed_cos_sq) : signed_cos_sq_(signed_cos_sq) {}

  const Fraction& signed_cos_sq() const { return signed_cos_sq_; }
  friend std::strong_ordering operator<=>(const Angle& a, const Angle& b) {
    return b.signed_cos_sq_ <=> a.signed_cos_sq_;
  }
  friend bool operator==(const Angle& a, const Angle& b) { return (a <=> b) == 0; }

 private:
  Fraction signed_cos_sq_;
};

inline constexpr Angle kAngle30{Fraction{3, 4}}, kAngle45{Fraction{1, 2}}, kAngle60{Fraction{1, 4}},
    kAngle90{Fraction{0, 1}}, kAngle120{Fraction{-1, 4}}, kAngle135{Fraction{-1, 2}};

/// For people: "30", "19.4712".
std::string text(const Angle& angle);
/// For people: the root of a fraction, "1.1180".
std::string root_text(const Fraction& squared);

}  // namespace unsliver::prover
