/// \file
/// Closed intervals with outward rounding, for sound bounds over boxes.
#pragma once

namespace unsliver::geom {

struct Interval {
  double lo = 0, hi = 0;
};

}  // namespace unsliver::geom
