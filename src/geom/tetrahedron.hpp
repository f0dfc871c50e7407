/// \file
/// Measures of one tetrahedron in plain doubles: for scores, searches and reports, never for topology.
#pragma once

#include "unsliver/types.hpp"

namespace unsliver::geom {

struct Sphere {
  Vec3 center;
  double radius_sq = 0;
};

/// The circumsphere. Flat tetrahedra give infinities or NaN.
inline Sphere circumsphere(const Tet& t) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0], w = t[3] - t[0];
  const Vec3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const double scale = 0.5 / dot(u, vw);
  const Vec3 c = scale * (norm_sq(u) * vw + norm_sq(v) * wu + norm_sq(w) * uv);
  return {t[0] + c, norm_sq(c)};
}

/// Signed volume, positive for positively oriented corners.
inline double volume(const Tet& t) { return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) / 6.0; }

/// Squared length of the shortest edge.
double shortest_edge_sq(const Tet& t);

/// circumradius / shortest edge; infinity for flat tetrahedra.
double radius_edge_ratio(const Tet& t);

/// Cotangents of the six dihedral angles, ordered by edges 01, 02, 03, 12, 13, 23: they fall from infinity to
/// -infinity as angles grow from 0 to pi, and cost far less. Independent of the orientation; infinite for
/// flat tetrahedra. Edges have to be between 1e-60 and 1e60 (powers up to the fifth).
std::array<double, 6> dihedral_cotangents(const Tet& t);

/// The angle in [0, pi] that has this cotangent.
inline double angle_of_cotangent(double cotangent) { return std::atan2(1.0, cotangent); }

/// The six dihedral angles in radians, in [0, pi], in the order of dihedral_cotangents.
std::array<double, 6> dihedral_angles(const Tet& t);

}  // namespace unsliver::geom
