/// \file
/// A static k-d tree over points: who lies in a cube or a ball, and how far the two nearest are.
///
/// The tree is complete and implicit: node i has the children 2i and 2i + 1, the leaves hold 8 to 17 points
/// each. A node stores where its two halves end along its axis, so queries skip the gap between them, which
/// keeps them fast on clusters.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::geom {

/// The tree, and so the order of visits, depends on the set of points alone, not on their order (ids included
/// only where points are equal). Queries are const and safe to call from several threads.
///
/// Cubes are exact: a point q is in the closed cube when center - half <= q <= center + half on every axis,
/// the bounds as computed in doubles; for integers below 2^52 they are exact too. Distances are those of
/// dist_sq(), with its rounding.
class PointTree {
 public:
  /// The id of a point is its position. Requires finite coordinates whose differences have squares in the
  /// range of doubles, and fewer than 2^32 - 1 points. O(n log n).
  explicit PointTree(std::span<const Vec3> points);

  std::size_t size() const { return points_.size(); }
  std::size_t bytes() const;

  struct TwoNearest {
    double first_sq, second_sq;
  };
  /// Squared distances from w to its nearest and second nearest point; infinity where there is none within
  /// the closed ball of squared radius within_sq. Equal points count each.
  TwoNearest two_nearest(const Vec3& w, double within_sq = std::numeric_limits<double>::infinity()) const;

  /// Do at least `count` points lie in the closed ball about w? Ends as soon as they are found. Requires
  /// radius >= 0.
  bool has_within(const Vec3& w, double radius, std::size_t count) const;

  /// The lexicographically smallest point in the closed cube; kNoVertex when there is none. Requires
  /// half >= 0.
  VertexId first_in_cube(const Vec3& center, double half) const;

  /// Does any point lie in the closed cube? Ends at the first one.
  bool has_in_cube(const Vec3& center, double half) const;

  /// Calls visit(id, point) for the points in the closed cube, until it returns true.
  template <class Visit>
  void visit_cube(const Vec3& center, double half, Visit&& visit) const {
    CubeQuery<Visit> query{{center, half}, *this, visit};
    walk(query);
  }

 private:
  /// Along the axis, the left half of a node ends at left_max and its right half begins at right_min.
  struct Cut {
    double left_max, right_min;
    int axis;
  };
  /// A closed cube, laid out for lookup by axis.
  struct Cube {
    Cube(const Vec3& center, double half)
        : lo{center.x - half, center.y - half, center.z - half},
          hi{center.x + half, center.y + half, center.z + half} {}
    bool has_left_of(const Cut& cut) const { return lo[cut.axis] <= cut.left_max; }
    bool has_right_of(const Cut& cut) const { return hi[cut.axis] >= cut.right_min; }
    bool contains(const Vec3& p) const {  // without branches, which nobody could predict
      const auto inside = [this](std::size_t axis, double c) {
        return int(lo[axis] <= c) & int(c <= hi[axis]);
      };
      return (inside(0, p.x) & inside(1, p.y) & inside(2, p.z)) != 0;
    }
    std::array<double, 3> lo, hi;
  };

  /// A query has a cube, which may shrink on the way; visit(from, to) for the points of a leaf, true =
  /// enough; and right_first(cut): which half of a node comes first.
  template <class Visit>
  struct CubeQuery {
    Cube cube;
    const PointTree& tree;
    Visit& on_point;

    static bool right_first(const Cut&) { return false; }
    bool visit(std::size_t from, std::size_t to) {
      for (; from < to; ++from)
        if (cube.contains(tree.points_[from]) && on_point(tree.ids_[from], tree.points_[from])) return true;
      return false;
    }
  };
  struct BallQuery;
  struct TwoNearestQuery;
  struct CountQuery;

  /// Nodes that wait for their turn; 0 stands for none.
  class Waiting {
   public:
    void push(std::uint32_t node) { nodes_[count_++] = node; }
    std::uint32_t pop() { return count_ == 0 ? 0 : nodes_[--count_]; }

   private:
    std::array<std::uint32_t, 32> nodes_;  // at most one for each depth
    std::size_t count_ = 0;
  };

  static constexpr std::size_t kLeafSize = 16;

  /// Where the points of a node begin; those of node `index` of its depth end where `index + 1` begins.
  std::size_t first_of(std::size_t index, int depth) const { return (points_.size() * index) >> depth; }
  void build(std::size_t node, int depth, std::span<const Vec3> points);

  /// Visits the leaves that reach into the query's cube.
  template <class Query>
  void walk(Query& query) const;
  template <class Query>
  std::uint32_t child_in_reach(const Query& query, std::uint32_t node, Waiting& waiting) const;
  std::uint32_t next_in_reach(const Cube& cube, Waiting& waiting) const;

  int depth_ = 0;             ///< of the leaves
  std::vector<Cut> cuts_;     ///< by node, from 1
  std::vector<Vec3> points_;  ///< leaf by leaf
  std::vector<VertexId> ids_;
};

template <class Query>
void PointTree::walk(Query& query) const {
  const std::uint32_t first_leaf = std::uint32_t{1} << depth_;
  Waiting waiting;
  for (std::uint32_t node = 1; node != 0; node = next_in_reach(query.cube, waiting)) {
    while (node != 0 && node < first_leaf) node = child_in_reach(query, node, waiting);
    if (node == 0) continue;
    const std::size_t leaf = node - first_leaf;
    if (query.visit(first_of(leaf, depth_), first_of(leaf + 1, depth_))) return;
  }
}

/// The child to go on with; 0 if none is in reach. Branches on purpose: a good guess fetches the next node
/// while this one is still being compared.
template <class Query>
std::uint32_t PointTree::child_in_reach(const Query& query, std::uint32_t node, Waiting& waiting) const {
  const Cut& cut = cuts_[node];
  const bool left = query.cube.has_left_of(cut), right = query.cube.has_right_of(cut);
  if (left && right) {
    const std::uint32_t first = 2 * node + (query.right_first(cut) ? 1 : 0);
    waiting.push(first ^ 1);
    return first;
  }
  if (left) return 2 * node;
  return right ? 2 * node + 1 : 0;
}

/// The next waiting node that the cube, which may have shrunk, still reaches; 0 if there is none.
inline std::uint32_t PointTree::next_in_reach(const Cube& cube, Waiting& waiting) const {
  while (const std::uint32_t node = waiting.pop()) {
    const Cut& cut = cuts_[node / 2];
    if (node % 2 == 0 ? cube.has_left_of(cut) : cube.has_right_of(cut)) return node;
  }
  return 0;
}

}  // namespace unsliver::geom
