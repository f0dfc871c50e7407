/// \file
/// The convex hull of points, as a surface to mesh.
#pragma once

#include <span>

#include "unsliver/mesh.hpp"

namespace unsliver {

/// The boundary of the points' convex hull, for make_surface: closed, outward, without self-intersections.
///
/// Exact for the points rounded to a grid, which moves no coordinate by more than 2^-47 of the longest side
/// of the points' box: by so little a point may stick out. mesh_domain, given the points as input vertices,
/// does not count that as outside. All points on the boundary are corners, those amid a face or an edge too,
/// and no triangle is degenerate. Takes as long as tetrahedralizing the points.
///
/// \throws Error kUnsupported where the points lie in a plane, on a line or at one place, within 1e-11 of
/// their extent, for then the hull has no volume; kBadInput where there are none, or one is not finite or out
/// of make_surface's range.
TriangleMesh convex_hull(std::span<const Vec3> points);

}  // namespace unsliver
