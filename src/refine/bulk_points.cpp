#include "refine/bulk_points.hpp"

#include <array>
#include <cmath>

namespace unsliver::refine {

namespace {

/// Is p, or what is next to it in the octant's direction, on the upper side of the plane at `middle`?
int upper(double p, double middle, int octant, int axis) {
  return p > middle || (p == middle && (octant >> axis & 1) != 0) ? 1 : 0;
}

}  // namespace

std::optional<octree::Cell> BulkPoints::leaf_at(const Vec3& p, int octant) const {
  const octree::Brick& brick = forest_.brick();
  const double side = lattice::power_of_two(brick.exponent);
  std::array<int, 3> index;
  for (int axis = 0; axis < 3; ++axis) {
    const double steps = (p[axis] - double(brick.lo[std::size_t(axis)])) / side, whole = std::floor(steps);
    const double i = steps == whole && (octant >> axis & 1) == 0 ? whole - 1 : whole;
    if (!(i >= 0 && i < brick.count[std::size_t(axis)])) return std::nullopt;
    index[std::size_t(axis)] = int(i);
  }
  octree::Cell cell = forest_.root_cell(index[0], index[1], index[2]);
  while (!forest_[cell.node].is_leaf()) {
    const Vec3 middle = cell.center();
    cell = forest_.child(cell, upper(p.x, middle.x, octant, 0) | upper(p.y, middle.y, octant, 1) << 1 |
                                   upper(p.z, middle.z, octant, 2) << 2);
  }
  return cell;
}

}  // namespace unsliver::refine
