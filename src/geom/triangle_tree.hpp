/// \file
/// A bounding-volume tree over the triangles of a surface: nearest distance, winding number, intersection
/// tests.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "unsliver/mesh.hpp"
#include "unsliver/types.hpp"

namespace unsliver::geom {

/// Requires finite coordinates; extents and their differences as in triangle_orient.hpp. Queries are const
/// and safe to call from several threads. Same input, same bits.
class TriangleTree {
 public:
  explicit TriangleTree(const TriangleMesh& surface);
  ~TriangleTree();
  TriangleTree(TriangleTree&&) noexcept;
  TriangleTree& operator=(TriangleTree&&) noexcept;

  struct Nearest {
    std::size_t triangle = 0;
    Vec3 point;
    double distance = 0;
  };
  /// The nearest point of the surface, searched only within `max_distance` (then distance = infinity if
  /// none).
  Nearest nearest(const Vec3& p, double max_distance) const;
  /// r >= 0: no point of the surface is closer to p than r, certainly; r is at least 0.7 times the distance
  /// to the surface (but for rounding). Much faster than `nearest` where many triangles are equally far.
  double clear_radius(const Vec3& p) const;
  /// Is the open ball about p certainly free of triangles? Ends at the first triangle that may be in it.
  bool is_clear(const Vec3& p, double radius) const;
  /// A lower bound of the distance from any point of the box to the surface; 0 if they may meet.
  double distance_lower_bound(const Box3& box) const;
  /// Generalized winding number at p (hierarchical; absolute error below 1e-3 away from the surface).
  double winding_number(const Vec3& p) const;
  /// Of a surface whose edges all run equally often both ways: the winding number at q minus that at p, by
  /// the triangles between them. Exact; nothing where the segment meets an edge, or p or q a triangle.
  std::optional<int> winding_gain(const Vec3& p, const Vec3& q) const;
  /// Could some triangle meet the closed tetrahedron? False is certain; true may be wrong only within
  /// rounding.
  bool may_meet(const Tet& t) const;
  /// Could some triangle meet the interior of the tetrahedron? False is certain, and exact where triangles
  /// touch it from outside; true may be wrong within rounding, for degenerate triangles and nearly parallel
  /// edges.
  bool may_meet_interior(const Tet& t) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unsliver::geom
