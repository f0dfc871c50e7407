/// \file
/// Gives equal points one id.
#pragma once

#include <cstdint>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::io {

/// A set of points, numbered in the order of their first appearance. Points are equal when their coordinates
/// are equal as numbers (so -0 equals 0); the first one's bits are kept.
class PointMerger {
 public:
  /// Requires finite coordinates and fewer than 2^32 - 1 different points.
  VertexId add(const Vec3& point);
  std::vector<Vec3> take_points() { return std::move(points_); }
  std::size_t size() const { return points_.size(); }

 private:
  std::size_t slot_of(const Vec3& point) const;
  void grow();

  std::vector<Vec3> points_;
  std::vector<VertexId> slots_ = std::vector<VertexId>(64, kNoVertex);  // open addressing, at most half full
};

}  // namespace unsliver::io
