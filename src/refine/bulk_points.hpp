/// \file
/// The vertices that a balanced forest gives, asked by place: corners of its leaves, and centres with
/// kHasCenter.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "lattice/level.hpp"
#include "octree/forest.hpp"

namespace unsliver::refine {

/// The nearest one of points that come one by one; of equally near ones the first.
class Nearest {
 public:
  Nearest(const Vec3& center, double radius) : center_(center), within_sq_(radius * radius) {}

  /// No point at a larger squared distance will do.
  double within_sq() const { return within_sq_; }
  const std::optional<Vec3>& found() const { return found_; }

  template <class Accept>
  void consider(const Vec3& p, const Accept& accept) {
    const double d = dist_sq(p, center_);
    if ((found_ ? d >= within_sq_ : d > within_sq_) || !accept(p)) return;
    found_ = p;
    within_sq_ = d;
  }

 private:
  Vec3 center_;
  double within_sq_;
  std::optional<Vec3> found_;
};

/// Points are world points.
class BulkPoints {
 public:
  explicit BulkPoints(const octree::Forest& forest) : forest_(forest) {}

  /// The leaf that holds p, or p's neighbourhood in the direction of `octant`; nothing beyond the forest.
  std::optional<octree::Cell> leaf_at(const Vec3& p, int octant = 7) const;

  /// The exponent of the smallest leaf that has p as a corner, or as its centre; nothing where p is no
  /// vertex. Calls visit(leaf) for those leaves, some more than once.
  template <class Visit>
  std::optional<int> exponent_at(const Vec3& p, const Visit& visit) const {
    std::optional<int> least;
    for (int octant = 0; octant < 8; ++octant) {
      const auto leaf = leaf_at(p, octant);
      if (!leaf || !has_vertex(*leaf, p)) continue;
      visit(*leaf);
      least = std::min(leaf->exponent, least.value_or(leaf->exponent));
    }
    return least;
  }
  std::optional<int> exponent_at(const Vec3& p) const {
    return exponent_at(p, [](const octree::Cell&) {});
  }

  /// The vertex nearest to the centre, of those in the closed ball that `accept` accepts.
  template <class Accept>
  std::optional<Vec3> nearest_if(const Vec3& center, double radius, const Accept& accept) const {
    Nearest nearest(center, radius);
    const auto consider = [&](const Vec3& p) { nearest.consider(p, accept); };
    if (const auto leaf = leaf_at(center)) visit_vertices(*leaf, consider);  // a good bound for the others
    visit_leaves(
        {center, center}, radius,
        [&](const octree::Node&, double distance_sq) { return distance_sq <= nearest.within_sq(); },
        [&](const octree::Cell& leaf, octree::NodeId) { visit_vertices(leaf, consider); });
    return nearest.found();
  }

  /// Calls visit(leaf, its parent) for leaves below nodes that enter(node, squared distance to the box) lets
  /// in, of those in roots that are within the distance of the box. Roots are their own parents.
  template <class Enter, class Visit>
  void visit_leaves(const Box3& box, double distance, const Enter& enter, const Visit& visit) const {
    const Range x = roots_across(box, distance, 0), y = roots_across(box, distance, 1),
                z = roots_across(box, distance, 2);
    for (int k = z.first; k <= z.last; ++k)
      for (int j = y.first; j <= y.last; ++j)
        for (int i = x.first; i <= x.last; ++i) {
          const octree::Cell root = forest_.root_cell(i, j, k);
          if (enter(forest_[root.node], dist_sq_between(root, box)))
            visit_below(root, root.node, box, enter, visit);
        }
  }

  /// Calls visit(p) for the leaf's vertices, its centre first.
  template <class Visit>
  void visit_vertices(const octree::Cell& leaf, const Visit& visit) const {
    if ((forest_[leaf.node].flags & octree::kHasCenter) != 0) visit(leaf.center());
    const double side = double(leaf.side());
    for (int number = 0; number < 8; ++number)
      visit(leaf.corner() + side * Vec3{double(number & 1), double(number >> 1 & 1), double(number >> 2)});
  }

  bool has_vertex(const octree::Cell& leaf, const Vec3& p) const {
    bool found = false;
    visit_vertices(leaf, [&](const Vec3& vertex) { found = found || vertex == p; });
    return found;
  }

  double root_side() const { return lattice::power_of_two(forest_.brick().exponent); }

  /// The squared distance of a cell and a box.
  static double dist_sq_between(const octree::Cell& cell, const Box3& box) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) sum += gap_sq(cell.corner()[axis], double(cell.side()), box, axis);
    return sum;
  }

 private:
  static double gap_sq(double lo, double side, const Box3& box, int axis) {
    const double gap = std::max(0.0, std::max(lo - box.hi[axis], box.lo[axis] - (lo + side)));
    return gap * gap;
  }

  template <class Enter, class Visit>
  void visit_below(const octree::Cell& cell, octree::NodeId parent, const Box3& box, const Enter& enter,
                   const Visit& visit) const {
    const octree::NodeId first = forest_[cell.node].link;
    if (forest_[cell.node].is_leaf()) return visit(cell, parent);
    double gaps_sq[3][2];
    const double half = 0.5 * double(cell.side());
    for (int axis = 0; axis < 3; ++axis)
      for (int upper = 0; upper < 2; ++upper)
        gaps_sq[axis][upper] = gap_sq(cell.corner()[axis] + upper * half, half, box, axis);
    for (int number = 0; number < 8; ++number)
      if (enter(forest_[first + number],
                gaps_sq[0][number & 1] + gaps_sq[1][number >> 1 & 1] + gaps_sq[2][number >> 2]))
        visit_below(forest_.child(cell, number), cell.node, box, enter, visit);
  }
  struct Range {
    int first, last;
  };
  Range roots_across(const Box3& box, double distance, int axis) const {
    const octree::Brick& brick = forest_.brick();
    const double lo = double(brick.lo[std::size_t(axis)]), most = brick.count[std::size_t(axis)] - 1;
    const auto index = [&](double c) {
      return int(std::clamp(std::floor((c - lo) / root_side()), 0.0, most));
    };
    return {index(box.lo[axis] - distance - 1), index(box.hi[axis] + distance)};
  }

  const octree::Forest& forest_;
};

}  // namespace unsliver::refine
