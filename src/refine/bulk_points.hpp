/// \file
/// The vertices that a balanced forest gives, asked by place: corners of its leaves, and centres with
/// kHasCenter.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "geom/triangle_bvh.hpp"
#include "lattice/level.hpp"
#include "octree/forest.hpp"

namespace unsliver::refine {

/// Points are world points.
class BulkPoints {
 public:
  explicit BulkPoints(const octree::Forest& forest) : forest_(forest) {}

  /// The exponent of the smallest leaf that has p as a corner, or as its centre; nothing where p is no
  /// vertex.
  std::optional<int> exponent_at(const Vec3& p) const;

  /// Calls visit(p) for vertices, among them all those in the closed ball, some more than once, until it
  /// returns true; begins around the centre.
  template <class Visit>
  void visit_ball(const Vec3& center, double radius, const Visit& visit) const {
    if (const auto leaf = leaf_at(center); leaf && visit_vertices(*leaf, visit)) return;
    const auto reaches = [&](const octree::Cell& cell) {
      return dist_sq_to(cell, center) <= radius * radius;
    };
    visit_cells(center, radius, reaches,
                [&](const octree::Cell& leaf, octree::NodeId) { return visit_vertices(leaf, visit); });
  }

  /// Calls visit(leaf, its parent) for leaves no farther from q than `share` of their side. Roots are their
  /// own parents.
  template <class Visit>
  void visit_leaves_near(const Vec3& q, double share, const Visit& visit) const {
    const double reach = share * lattice::power_of_two(forest_.brick().exponent);
    const auto reaches = [&](const octree::Cell& cell) { return is_near(cell, q, share); };
    visit_cells(q, reach, reaches, [&](const octree::Cell& leaf, octree::NodeId parent) {
      visit(leaf, parent);
      return false;
    });
  }
  /// Calls visit(p) for the vertices of these leaves.
  template <class Visit>
  void visit_near(const Vec3& q, double share, const Visit& visit) const {
    visit_leaves_near(q, share, [&](const octree::Cell& leaf, octree::NodeId) {
      visit_vertices(leaf, [&](const Vec3& p) { return visit(p), false; });
    });
  }

  static bool is_near(const octree::Cell& cell, const Vec3& q, double share) {
    const double reach = share * double(cell.side());
    return dist_sq_to(cell, q) <= reach * reach;
  }

 private:
  static double dist_sq_to(const octree::Cell& cell, const Vec3& q) {
    const double side = double(cell.side());
    return geom::dist_sq(q, {cell.corner(), cell.corner() + Vec3{side, side, side}});
  }
  static Vec3 corner_of(const octree::Cell& cell, int number) {
    const double side = double(cell.side());
    return cell.corner() + side * Vec3{double(number & 1), double(number >> 1 & 1), double(number >> 2)};
  }

  template <class Visit>
  bool visit_vertices(const octree::Cell& leaf, const Visit& visit) const {
    if ((forest_[leaf.node].flags & octree::kHasCenter) != 0 && visit(leaf.center())) return true;
    for (int number = 0; number < 8; ++number)
      if (visit(corner_of(leaf, number))) return true;
    return false;
  }

  /// Leaves below nodes that `enter` lets in, those in roots that the ball may reach.
  template <class Enter, class Visit>
  void visit_cells(const Vec3& center, double radius, const Enter& enter, const Visit& visit) const {
    const Range x = roots_across(center.x, radius, 0), y = roots_across(center.y, radius, 1),
                z = roots_across(center.z, radius, 2);
    for (int k = z.first; k <= z.last; ++k)
      for (int j = y.first; j <= y.last; ++j)
        for (int i = x.first; i <= x.last; ++i) {
          const octree::Cell root = forest_.root_cell(i, j, k);
          if (visit_below(root, root.node, enter, visit)) return;
        }
  }
  template <class Enter, class Visit>
  bool visit_below(const octree::Cell& cell, octree::NodeId parent, const Enter& enter,
                   const Visit& visit) const {
    if (!enter(cell)) return false;
    if (forest_[cell.node].is_leaf()) return visit(cell, parent);
    for (int number = 0; number < 8; ++number)
      if (visit_below(forest_.child(cell, number), cell.node, enter, visit)) return true;
    return false;
  }
  struct Range {
    int first, last;
  };
  Range roots_across(double center, double radius, std::size_t axis) const {
    const octree::Brick& brick = forest_.brick();
    const double side = lattice::power_of_two(brick.exponent), most = brick.count[axis] - 1;
    const auto index = [&](double c) {
      return int(std::clamp(std::floor((c - double(brick.lo[axis])) / side), 0.0, most));
    };
    return {index(center - radius - 1), index(center + radius)};
  }

  /// The leaf that holds p, or p's neighbourhood in the direction of `octant`; nothing beyond the forest.
  std::optional<octree::Cell> leaf_at(const Vec3& p, int octant = 7) const;

  const octree::Forest& forest_;
};

}  // namespace unsliver::refine
