/// \file
/// The guarantee as rationals: signed cot^2 of the angles, the square of the ratio.
#pragma once

#include <optional>

#include "unsliver/verify.hpp"
#include "verify/numbers.hpp"

namespace unsliver::verifier {

/// num / den, den > 0, and the same in doubles.
struct Threshold {
  BigInt num, den;
  double num_d = 0, den_d = 1;  ///< their quotient errs by at most two roundings
  bool small = false;           ///< |num|, den < 2^10: the doubles are exact
};

/// What must hold of every tetrahedron; an absent bound asks nothing.
struct Bounds {
  std::optional<Threshold> min_angle;  ///< signed cot^2 <= this
  std::optional<Threshold> max_angle;  ///< signed cot^2 >= this
  std::optional<Threshold> ratio;      ///< (circumradius / shortest edge)^2 <= this
};

/// 30, 45, 60, 90, 120, 135, 150 degrees and sqrt(5)/2 (to 1e-15) become the numbers they stand for. The
/// cot^2 of any other angle is irrational: it is replaced by a multiple of 2^-200 that asks less, by at most
/// 2^-199. Other ratios are taken as the doubles they are. min <= 0, max >= 180, ratio = infinity or NaN: no
/// bound.
Bounds make_bounds(const QualityGuarantee& guarantee);

}  // namespace unsliver::verifier
