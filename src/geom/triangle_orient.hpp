/// \file
/// Orientation signs of arbitrary doubles, never wrong: for surfaces, whose coordinates are on no grid.
///
/// Requires of all functions: finite coordinates; every difference is 0 or between 1e-90 and 1e90 in
/// magnitude, so that no product overflows or underflows.
#pragma once

#include "unsliver/types.hpp"

namespace unsliver::geom {

/// From one point to another, not rounded.
struct ExactStep {
  Vec3 from, to;
};

/// Sign of the determinant of three vectors.
int exact_det(const ExactStep& r, const ExactStep& s, const ExactStep& t);

/// Sign of det(b - a, c - a, d - a).
int exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sign of the area of (a, b, c) projected on the axes (u, v): det of rows (b - a), (c - a).
int exact_orient2d(const Vec3& a, const Vec3& b, const Vec3& c, int u, int v);

}  // namespace unsliver::geom
