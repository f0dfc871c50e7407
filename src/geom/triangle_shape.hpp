/// \file
/// One triangle: nearest point, solid angle, and whether it meets a tetrahedron or another triangle.
#pragma once

#include <array>
#include <optional>

#include "geom/triangle_orient.hpp"
#include "unsliver/types.hpp"

namespace unsliver::geom {

using Triangle = std::array<Vec3, 3>;

inline Box3 bounding_box(const Triangle& t) {
  Box3 box;
  for (const Vec3& p : t) box.extend(p);
  return box;
}

/// Twice the area, along the normal.
inline Vec3 area_vector(const Triangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// A point of the triangle nearest to p, up to closest_point_slack. Degenerate triangles are segments or
/// points.
Vec3 closest_point(const Triangle& t, const Vec3& p);

/// k such that |p - closest_point(t, p)| exceeds the true distance by at most
/// k (longest edge + true distance). At most about 1e-7, which only slivers reach.
double closest_point_slack(const Triangle& t);

/// (Solid angle of t seen from p) / 4 pi, positive where p is behind the triangle (its normal points away
/// from p), in [-1/2, 1/2]. Error below 1e-7 unless p is within rounding of the triangle's plane. Plain
/// arithmetic: the same bits everywhere.
double winding_of(const Triangle& t, const Vec3& p);

/// How much a closed surface's winding number gains through t on the way from p to q: 1 if it goes through
/// the front, -1 through the back, 0 if it misses. Exact; nothing where p, q or an edge makes it ambiguous.
std::optional<int> winding_gain(const Triangle& t, const Vec3& p, const Vec3& q);

/// A tetrahedron made ready to be compared with many triangles and boxes.
class TetProbe {
 public:
  /// What is asked about: the open tetrahedron, or the closed one.
  enum class Extent { kInterior, kClosed };

  TetProbe(const Tet& tet, Extent extent);

  /// False: the box is certainly disjoint from the extent.
  bool may_meet(const Box3& box) const;
  /// False: the triangle is certainly disjoint from the extent. True may be wrong within rounding: of the
  /// interior only where two edges are nearly parallel, of the closed tetrahedron wherever it nearly touches.
  bool may_meet(const Triangle& triangle) const;

 private:
  bool apart(double low, double high) const;
  bool face_separates(const Triangle& triangle) const;
  bool plane_separates(const Triangle& triangle) const;
  bool edges_separate(const Triangle& triangle) const;
  bool touch_separates(const ExactStep& e, const ExactStep& f, const Triangle& triangle) const;

  Tet tet_;
  Extent extent_;
  Box3 box_;
  int orientation_;
  std::array<Vec3, 4> outward_;  ///< a normal of the face opposite to each corner, rounded
};

/// The first `shared` (0, 1 or 2) corners of the two closed triangles are the same points, s[i] = t[i]. Have
/// they a point in common besides that corner or edge? Exact, unless one is degenerate.
bool triangles_cross(const Triangle& s, const Triangle& t, int shared);

}  // namespace unsliver::geom
