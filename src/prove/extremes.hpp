/// \file
/// The largest of many quantities over a box of places of p, certified by subdivision.
#pragma once

#include <vector>

#include "prove/quantity.hpp"
#include "prove/surd.hpp"

namespace unsliver::prover {

/// p_axis is in [lo, hi], both in quarters.
struct Range {
  Surd lo, hi;
};
using Region = std::array<Range, 3>;

/// A corner of a region, bit a for the upper end of axis a.
inline Vector<Surd> corner(const Region& region, int c) {
  const auto end = [&](int axis) {
    const Range& range = region[std::size_t(axis)];
    return (c >> axis & 1) != 0 ? range.hi : range.lo;
  };
  return {end(0), end(1), end(2)};
}

struct Extreme {
  SurdFraction value{-1, 1};  ///< exact
  /// The quantities and corners of the region where it is attained.
  struct Place {
    Quantity quantity;
    int corner;
  };
  std::vector<Place> places;
  /// False if some box could be neither excluded nor followed to a corner; then `value` is a lower bound
  /// only.
  bool is_certain = true;
};

/// The supremum over the closed region and all quantities. Boxes whose enclosure is below a value that is
/// attained are dropped; along an axis with a slope of one sign only that end of a box is kept. What is left
/// are corners, and these are compared exactly.
Extreme largest(const std::vector<Quantity>& quantities, const Region& region);

}  // namespace unsliver::prover
