/// \file
/// The parents of a lattice point, and sets that are closed under them (docs/CLOSURE.md).
///
/// A set of lattice points that holds the parents of each of its points has a Delaunay tetrahedralization
/// with dihedral angles in [30, 135] degrees and radius-edge ratios of at most sqrt(5)/2.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "lattice/level.hpp"

namespace unsliver::lattice {

/// The parents of a point v of canonical level L(v), all of them in the next coarser lattice L(v) + 1:
/// - v in SC_k but not BCC_{k+1}, the middle of an edge or a face of a cube of side 2^{k+1}: six points,
///   v +- 2^k along the edge or the face's normal, and v +- 2^k in both other directions;
/// - v in BCC_k but not SC_k: the eight corners of its cube.
class Parents {
 public:
  /// Requires: v is an integer point, not the origin (which has no coarsest lattice).
  explicit Parents(const Vec3& v);

  const Vec3* begin() const { return points_.data(); }
  const Vec3* end() const { return points_.data() + count_; }
  std::size_t size() const { return count_; }

 private:
  void add(const Vec3& p) { points_[count_++] = p; }

  std::array<Vec3, 8> points_;
  std::size_t count_ = 0;
};

/// The smallest set that holds the points, and with each point of canonical level below `coarsest` its
/// parents; in lexicographic order. O(n log n) for a result of n points.
std::vector<Vec3> closure(std::span<const Vec3> points, Level coarsest);

}  // namespace unsliver::lattice
