/// \file
/// The region {winding number > 1/2} of a surface, and what is certain of it between the triangles.
#pragma once

#include "domain/surface_rim.hpp"
#include "geom/triangle_tree.hpp"

namespace unsliver::domain {

/// kUnknown may be either or both.
enum class Side : std::int8_t { kInside = -1, kUnknown = 0, kOutside = 1 };

class SurfaceRegion {
 public:
  /// `triangles` of positive area; `uses` of all of them.
  SurfaceRegion(const TriangleMesh& triangles, const std::vector<EdgeUse>& uses)
      : tree_(triangles), rim_(uses, triangles.points) {}

  const geom::TriangleTree& tree() const { return tree_; }

  /// The winding number is constant between the triangles.
  bool is_closed() const { return rim_.empty(); }

  double winding_number(const Vec3& p) const { return tree_.winding_number(p); }
  bool holds(const Vec3& p) const { return tree_.winding_number(p) > 0.5; }

  /// The side of all points within `radius` of p that p sees: that a segment free of triangles joins to p.
  Side side_around(const Vec3& p, double radius) const;

  /// Like Domain::clearance, of an open surface, given that no triangle is closer to p than `radius`.
  double clearance(const Vec3& p, double radius) const;

  /// Could some point of t be in the region of an open surface? No triangle meets the interior of t.
  /// False is certain.
  bool may_hold_part_of(const Tet& t) const { return may_hold_part_of(t, kMostSplits); }

 private:
  /// A tetrahedron that straddles the level 1/2 is cut into at most 2^6 pieces before it is kept for safety.
  static constexpr int kMostSplits = 6;
  bool may_hold_part_of(const Tet& t, int splits_left) const;

  geom::TriangleTree tree_;
  SurfaceRim rim_;
};

}  // namespace unsliver::domain
