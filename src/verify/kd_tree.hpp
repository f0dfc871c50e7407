/// \file
/// A static k-d tree over points: nearest point and points in a box.
#pragma once

#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::verifier {

class KdTree {
 public:
  struct Nearest {
    VertexId id = kNoVertex;  ///< kNoVertex: there is none
    double dist_sq = std::numeric_limits<double>::infinity();
  };

  /// Holds points[id] for each of `ids`. Requires: finite coordinates. O(n log n).
  KdTree(const std::vector<Vec3>& points, std::vector<VertexId> ids);

  /// The nearest point with an id other than `except`.
  Nearest nearest(const Vec3& p, VertexId except = kNoVertex) const;

  /// Calls visit(id, point) for every point in the closed box.
  template <class Visit>
  void visit_box(const Box3& box, Visit&& visit) const {
    visit_range(0, items_.size(), box, visit);
  }

 private:
  struct Item {
    Vec3 point;
    VertexId id;
    int axis = 0;  ///< of the cut through this item, where it is a middle
  };
  static constexpr std::size_t kLeafSize = 8;

  void build(std::size_t from, std::size_t to);
  void search(std::size_t from, std::size_t to, const Vec3& p, VertexId except, Nearest& best) const;

  template <class Visit>
  void visit_range(std::size_t from, std::size_t to, const Box3& box, Visit& visit) const {
    while (to - from > kLeafSize) {
      const std::size_t middle = from + (to - from) / 2;
      const Item& item = items_[middle];
      const double cut = item.point[item.axis];
      if (cut >= box.lo[item.axis]) visit_range(from, middle, box, visit);
      if (cut > box.hi[item.axis]) return;
      if (box.contains(item.point)) visit(item.id, item.point);
      from = middle + 1;
    }
    for (; from < to; ++from) {
      if (box.contains(items_[from].point)) visit(items_[from].id, items_[from].point);
    }
  }

  std::vector<Item> items_;  ///< the middle of a range cuts it in two along its axis
};

}  // namespace unsliver::verifier
