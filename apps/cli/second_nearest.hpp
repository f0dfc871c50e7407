/// \file
/// The local feature size of a set of points.
#pragma once

#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::cli {

/// How far the second nearest of some finite points is: lfs_i of the paper's Definition 1. Equal points count
/// as one. A k-d tree laid out in place: the middle of each range splits it along its longest side.
class SecondNearest {
 public:
  explicit SecondNearest(std::vector<Vec3> points);

  /// Infinite where there are fewer than two points.
  double distance(const Vec3& p) const;

 private:
  struct Found {
    double first_sq, second_sq;
  };
  void build(std::size_t begin, std::size_t end);
  void search(std::size_t begin, std::size_t end, const Vec3& p, Found& found) const;

  std::vector<Vec3> points_;
  std::vector<std::uint8_t> axes_;  ///< along which each point splits its range
};

}  // namespace unsliver::cli
