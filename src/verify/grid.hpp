/// \file
/// Coordinates on the integer grid of a frame, decided exactly.
#pragma once

#include "unsliver/mesh.hpp"
#include "verify/numbers.hpp"

namespace unsliver::verifier {

/// The place of one coordinate on a grid.
struct GridPlace {
  bool in_range = false;  ///< |q| <= 2^60; otherwise the rest is not set
  bool exact = false;     ///< x = origin + unit * q
  std::int64_t q = 0;     ///< nearest integer to (x - origin) / unit, ties to even
  double offset = 0;      ///< |x - origin - unit * q| / unit, rounded
};

/// Largest integer coordinate: differences of two then fit 62 bits.
inline constexpr std::int64_t kGridLimit = std::int64_t{1} << 60;

/// One axis of a frame: reads coordinates as integers. Cheap when x is on the grid.
class GridAxis {
 public:
  /// Requires: finite, unit > 0.
  GridAxis(double unit, double origin);

  /// Requires: x finite. Exact whatever the frame.
  GridPlace place(double x) const;

 private:
  GridPlace place_slowly(double x) const;

  double unit_, origin_;
  double exact_limit_;  ///< unit * q is an exact double for every integer |q| up to this
};

}  // namespace unsliver::verifier
