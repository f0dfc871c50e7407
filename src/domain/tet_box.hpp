/// \file
/// Tetrahedron against box, exactly.
#pragma once

#include "unsliver/types.hpp"

namespace unsliver::domain {

inline Vec3 centroid(const Tet& t) { return t[0] + 0.25 * ((t[1] - t[0]) + (t[2] - t[0]) + (t[3] - t[0])); }

/// Do the interior of t (of any orientation) and the closed box of positive sides have a point in common?
/// Exact: touching at the boundary is no. Coordinates as in require_usable_range.
bool interior_meets_box(const Tet& t, const Box3& box);

/// Distance from p to the nearest point of the box, 0 inside; rounded down.
double distance_to_box(const Vec3& p, const Box3& box);

/// Distance from p, in the box, to its boundary; rounded down, 0 outside.
double depth_in_box(const Vec3& p, const Box3& box);

}  // namespace unsliver::domain
