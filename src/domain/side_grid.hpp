/// \file
/// A coarse map of a surface's surroundings: for each cube of a grid, the side it is on and how many cubes
/// away the nearest one is that the surface runs through. It answers for points far from the surface at once.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "domain/surface_region.hpp"
#include "unsliver/mesh.hpp"

namespace unsliver::domain {

class SideGrid {
 public:
  /// Over `bounds`, the box of the surface; all beyond it is outside. O(triangles + cells), in sequence.
  /// `region` must outlive the grid.
  SideGrid(const TriangleMesh& surface, const Box3& bounds, const SurfaceRegion& region);

  /// Is p, in the bounds, in the region? Between the triangles of a closed surface the answer is exact, by
  /// counting crossings on the way to a decided cube.
  bool holds(const Vec3& p) const;

  /// Like Domain::clearance, in coarse steps; 0 near the surface.
  double clearance(const Vec3& p) const;

  /// Side of a cube.
  double cell() const { return cell_; }

  /// Volume of the cubes inside and half of the undecided ones.
  double inside_volume() const;

 private:
  using Index = std::array<int, 3>;
  /// Cells first <= index < last along each axis.
  struct Block {
    Index first, last;
  };
  struct Cell {
    /// 0: undecided. Otherwise steps (diagonal ones too) to the nearest undecided cell, at most kMostSteps;
    /// inside also to the rim of the grid. Negative inside, positive outside.
    std::int8_t steps = 0;
    std::int8_t winding = 0;  ///< of a decided cell of a closed surface
  };
  class Filler;

  std::size_t at(const Index& i) const {
    return (static_cast<std::size_t>(i[2]) * count_[1] + i[1]) * count_[0] + i[0];
  }
  bool in_grid(const Index& i) const {
    return 0 <= i[0] && i[0] < count_[0] && 0 <= i[1] && i[1] < count_[1] && 0 <= i[2] && i[2] < count_[2];
  }
  Vec3 in_cells(const Vec3& p) const { return (1 / cell_) * (p - bounds_.lo); }
  std::optional<int> winding_by_way_of(const Index& i, const Vec3& p) const;
  void measure_steps();
  void sweep(int direction);

  const SurfaceRegion& region_;
  Box3 bounds_;
  double cell_ = 1;  ///< side of a cube
  Index count_{};
  std::vector<Cell> cells_;
};

}  // namespace unsliver::domain
