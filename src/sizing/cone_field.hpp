/// \file
/// The lower envelope of cones that stand on boxes.
#pragma once

#include <vector>

#include "geom/triangle_bvh.hpp"
#include "unsliver/types.hpp"

namespace unsliver::sizing {

/// s(p) = min over i of heights[i] + slope * distance(p, boxes[i]); points are boxes without extent.
///
/// A minimum of functions that are slope-Lipschitz in the Euclidean distance is slope-Lipschitz itself, with
/// no factor for a grid's directions.
class ConeField {
 public:
  /// Requires one height a box, slope >= 0.
  ConeField(std::vector<Box3> boxes, std::vector<double> heights, double slope);

  /// min(limit, the least of s over the query box), as computed at the best of its points: monotone rounding
  /// makes this a bound of what is computed at any point of the box.
  double least_over(const Box3& query, double limit) const;
  double at(const Vec3& p, double limit) const { return least_over({p, p}, limit); }

  std::size_t size() const { return boxes_.size(); }

 private:
  std::vector<Box3> boxes_;
  std::vector<double> heights_;
  double slope_;
  geom::BoxTree tree_;
  std::vector<double> node_heights_;
};

}  // namespace unsliver::sizing
