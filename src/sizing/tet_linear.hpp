/// \file
/// The linear function on a tetrahedron with given corner values.
#pragma once

#include <algorithm>
#include <array>

#include "unsliver/types.hpp"

namespace unsliver::sizing {

class TetLinear {
 public:
  TetLinear(const Tet& corners, const std::array<double, 4>& values);

  /// Too flat for barycentric coordinates to mean anything.
  bool is_flat() const { return flatness_ < 1e-14; }
  /// Barycentric coordinates; they add up to 1. Requires !is_flat().
  std::array<double, 4> coordinates(const Vec3& p) const;
  /// Requires !is_flat().
  Vec3 gradient() const;
  /// False only if the box and the tetrahedron are certainly apart.
  bool may_meet(const Box3& box) const;
  /// At most the value at any point of the box within the tetrahedron.
  double lower_bound(const Box3& box) const;

 private:
  Tet corners_;
  std::array<double, 4> values_;
  std::array<Vec3, 3> rows_;  ///< gradients of the coordinates of corners 1, 2, 3
  double flatness_;           ///< 6 volumes over the cube of the longest edge from corner 0
};

/// Barycentric coordinates of a point p of a triangle, cut to [0, 1]; they add up to 1.
std::array<double, 3> triangle_coordinates(const std::array<Vec3, 3>& corners, const Vec3& p);

}  // namespace unsliver::sizing
