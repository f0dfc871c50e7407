/// \file
/// A bounding-volume tree over the triangles of a surface: nearest distance, winding number, intersection
/// tests.
#pragma once

#include <memory>
#include <vector>

#include "unsliver/mesh.hpp"
#include "unsliver/types.hpp"

namespace unsliver::geom {

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
  /// A lower bound of the distance from any point of the box to the surface; 0 if they may meet.
  double distance_lower_bound(const Box3& box) const;
  /// Generalized winding number at p (hierarchical; absolute error below 1e-3 away from the surface).
  double winding_number(const Vec3& p) const;
  /// Could some triangle meet the closed tetrahedron? False is certain; true may be wrong only within
  /// rounding.
  bool may_meet(const Tet& t) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace unsliver::geom
