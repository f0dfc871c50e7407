/// \file
/// Small octrees by brute force: what goes wrong without parent closure.
#pragma once

#include <compare>
#include <set>

#include "prove/finding.hpp"

namespace unsliver::prover {

/// A leaf: lower corner and side.
struct Cube {
  Point at;
  std::int64_t side;
  friend auto operator<=>(const Cube&, const Cube&) = default;
};

/// A brick of cubes of side 8, each the root of an octree.
class SmallForest {
 public:
  SmallForest(int nx, int ny, int nz);
  explicit SmallForest(std::set<Cube> leaves) : leaves_(std::move(leaves)) {}

  const std::set<Cube>& leaves() const { return leaves_; }
  /// Requires a leaf of side 2 or more.
  void split(const Cube& leaf);

  /// Do the sides of leaves that share part of a face differ by at most a factor of 2? Of an edge?
  bool is_balanced_across_faces() const { return is_balanced(2); }
  bool is_balanced_across_edges() const { return is_balanced(1); }

  /// All corners of leaves and, if asked for, the centres of the leaves on which a corner hangs.
  std::vector<Point> vertices(bool with_centers) const;

 private:
  /// For leaves that share a set of this dimension.
  bool is_balanced(int dimension) const;

  std::set<Cube> leaves_;
};

/// The shape of all tetrahedra with empty open circumballs, whatever breaks ties. O(n^5) at worst.
Shape delaunay_shape(const std::vector<Point>& points);

/// The smallest forests, by splits and then by roots, with an angle outside [30, 135] degrees.
struct Counterexamples {
  /// Balanced across faces only, with centres where corners hang.
  int face_balance_splits = 4, face_balance_roots = 4, face_balance_vertices = 97;
  Shape face_balance{Angle({5, 6}), Angle({-2, 3}), {9, 4}};
  /// Balanced across faces and edges, without centres.
  int corners_only_splits = 1, corners_only_roots = 2, corners_only_vertices = 31;
  Shape corners_only{Angle({4, 5}), Angle({-1, 3}), {29, 16}};
};
Finding prove_counterexamples(const Counterexamples& claim = {});

}  // namespace unsliver::prover
