/// \file
/// Best-first subdivision of a box: a sharp bound from a bound that is only sharp on small boxes.
#pragma once

#include <cmath>
#include <queue>
#include <utility>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::sizing {

inline std::pair<Box3, Box3> halves(const Box3& box, int axis) {
  std::pair<Box3, Box3> parts{box, box};
  parts.first.hi[axis] = parts.second.lo[axis] = box.center()[axis];
  return parts;
}

/// An upper bound of a function f over the box, within about `tolerance` (relative) of the supremum when
/// `most_parts` suffice. Requires upper(b) >= f on b and lower(b) <= sup of f on b;
/// cut_axis(b) says which axis to halve b along.
template <class Upper, class Lower, class CutAxis>
double upper_bound(const Box3& box, Upper upper, Lower lower, CutAxis cut_axis, double tolerance,
                   int most_parts) {
  const auto below = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::priority_queue<std::pair<double, Box3>, std::vector<std::pair<double, Box3>>, decltype(below)> parts(
      below);
  double reached = lower(box);
  parts.push({upper(box), box});
  for (int i = 0; i < most_parts; ++i) {
    const auto [bound, part] = parts.top();
    if (bound - reached <= tolerance * std::fabs(reached)) break;
    parts.pop();
    const auto [left, right] = halves(part, cut_axis(part));
    for (const Box3& half : {left, right}) {
      reached = std::fmax(reached, lower(half));
      parts.push({std::fmin(upper(half), bound), half});
    }
  }
  return parts.top().first;
}

}  // namespace unsliver::sizing
