/// \file
/// Positive values on a regular grid, interpolated trilinearly.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "unsliver/types.hpp"

namespace unsliver::sizing {

/// The nodes of a grid over a box: counts[k] >= 2 along axis k, the first axis running fastest.
struct GridShape {
  Box3 bounds;
  std::array<std::uint32_t, 3> counts;

  /// About `samples` nodes in cells as cubic as can be. Requires bounds with positive sides, samples >= 8.
  static GridShape about(const Box3& bounds, std::size_t samples);

  std::size_t node_count() const { return std::size_t{counts[0]} * counts[1] * counts[2]; }
  std::size_t index(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return (std::size_t{k} * counts[1] + j) * counts[0] + i;
  }
  Vec3 node(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;
  /// "65 x 65 x 33 points, (0.1, 0.1, 0.1) apart".
  std::string describe() const;
};

/// Outside the bounds: the value at the nearest point of them.
class Grid {
 public:
  /// Requires one value a node, all finite and > 0.
  Grid(const GridShape& shape, std::vector<double> values);

  double at(const Vec3& p) const;
  /// Exact up to rounding, from below, for boxes of a few cells; the least node about it for larger ones.
  double lower_bound(const Box3& box) const;
  double lipschitz() const { return lipschitz_; }
  const GridShape& shape() const { return shape_; }

 private:
  struct Place {
    std::uint32_t cell;
    double offset;  ///< within the cell, in [0, 1]
  };
  /// The least node value of each block of 2^level cells a side.
  struct Blocks {
    std::array<std::uint32_t, 3> counts;
    std::vector<double> least;
    double at(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
      return least[(std::size_t{k} * counts[1] + j) * counts[0] + i];
    }
  };
  struct Range;

  Place place(double coordinate, int axis) const;
  double interpolate(const std::array<std::uint32_t, 3>& cell, const Vec3& offset) const;
  double least_in_cell(const std::array<std::uint32_t, 3>& cell, const std::array<Range, 3>& ranges) const;
  Blocks cell_minima() const;
  static Blocks coarser(const Blocks& fine);
  double steepest() const;

  GridShape shape_;
  std::vector<double> values_;
  std::vector<Blocks> levels_;
  double lipschitz_;
};

}  // namespace unsliver::sizing
