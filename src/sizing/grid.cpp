#include "sizing/grid.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace unsliver::sizing {
namespace {

/// Relative rounding error of an interpolated value: three roundings a step, three steps, all terms positive.
constexpr double kSlack = 32 * std::numeric_limits<double>::epsilon();
/// Boxes of at most so many cells a side are bounded cell by cell.
constexpr std::uint32_t kFewCells = 2;

double blend(double a, double b, double t) { return (1 - t) * a + t * b; }

/// Calls f(i, j, k) for 0 <= i < counts[0], ...
template <class F>
void for_each(const std::array<std::uint32_t, 3>& counts, F f) {
  for (std::uint32_t k = 0; k < counts[2]; ++k)
    for (std::uint32_t j = 0; j < counts[1]; ++j)
      for (std::uint32_t i = 0; i < counts[0]; ++i) f(i, j, k);
}

std::array<std::uint32_t, 3> cell_counts(const GridShape& shape) {
  return {shape.counts[0] - 1, shape.counts[1] - 1, shape.counts[2] - 1};
}

}  // namespace

GridShape GridShape::about(const Box3& bounds, std::size_t samples) {
  const Vec3 side = bounds.size();
  // Bisection for the spacing: the number of nodes falls as it grows, also for boxes thinner than a cell.
  const auto counts_at = [&side](double spacing) {
    std::array<std::uint32_t, 3> counts;
    for (int axis = 0; axis < 3; ++axis)
      counts[axis] = 2 + static_cast<std::uint32_t>(std::clamp(side[axis] / spacing - 0.5, 0.0, 1e9));
    return counts;
  };
  double fine = bounds.longest_side() / static_cast<double>(samples), coarse = bounds.longest_side();
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(fine * coarse);
    const auto c = counts_at(middle);
    const bool too_many = static_cast<double>(c[0]) * c[1] * c[2] > static_cast<double>(samples);
    (too_many ? fine : coarse) = middle;
  }
  return {bounds, counts_at(coarse)};
}

Vec3 GridShape::node(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  const std::array<std::uint32_t, 3> index{i, j, k};
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis)
    p[axis] = blend(bounds.lo[axis], bounds.hi[axis],
                    static_cast<double>(index[axis]) / static_cast<double>(counts[axis] - 1));
  return p;
}

std::string GridShape::describe() const {
  const Vec3 side = bounds.size();
  return fmt::format("{} x {} x {} points, ({:.4g}, {:.4g}, {:.4g}) apart", counts[0], counts[1], counts[2],
                     side.x / (counts[0] - 1), side.y / (counts[1] - 1), side.z / (counts[2] - 1));
}

/// The places of a box's two ends along an axis.
struct Grid::Range {
  Place lo, hi;

  /// The part of the range in a cell, as offsets within it.
  double from(std::uint32_t cell) const { return cell == lo.cell ? lo.offset : 0; }
  double to(std::uint32_t cell) const { return cell == hi.cell ? hi.offset : 1; }
};

Grid::Grid(const GridShape& shape, std::vector<double> values) : shape_(shape), values_(std::move(values)) {
  levels_.push_back(cell_minima());
  while (levels_.back().least.size() > 1) levels_.push_back(coarser(levels_.back()));
  lipschitz_ = steepest();
}

Grid::Place Grid::place(double coordinate, int axis) const {
  const double lo = shape_.bounds.lo[axis], hi = shape_.bounds.hi[axis];
  const std::uint32_t cells = shape_.counts[axis] - 1;
  const double t = (std::clamp(coordinate, lo, hi) - lo) / (hi - lo) * cells;
  const auto cell = std::min(static_cast<std::uint32_t>(t), cells - 1);
  return {cell, std::min(t - cell, 1.0)};
}

double Grid::interpolate(const std::array<std::uint32_t, 3>& cell, const Vec3& offset) const {
  const double* corner = &values_[shape_.index(cell[0], cell[1], cell[2])];
  const std::size_t row = shape_.counts[0], layer = row * shape_.counts[1];
  const auto along_x = [&](const double* v) { return blend(v[0], v[1], offset.x); };
  const double near = blend(along_x(corner), along_x(corner + row), offset.y);
  const double far = blend(along_x(corner + layer), along_x(corner + layer + row), offset.y);
  return blend(near, far, offset.z);
}

double Grid::at(const Vec3& p) const {
  const Place x = place(p.x, 0), y = place(p.y, 1), z = place(p.z, 2);
  return interpolate({x.cell, y.cell, z.cell}, {x.offset, y.offset, z.offset});
}

/// A function that is linear along each axis takes its least value over a box at a corner.
double Grid::least_in_cell(const std::array<std::uint32_t, 3>& cell,
                           const std::array<Range, 3>& ranges) const {
  double least = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 offset;
    for (int axis = 0; axis < 3; ++axis) {
      const Range& r = ranges[axis];
      offset[axis] = corner >> axis & 1 ? r.to(cell[axis]) : r.from(cell[axis]);
    }
    least = std::min(least, interpolate(cell, offset));
  }
  return least;
}

double Grid::lower_bound(const Box3& box) const {
  std::array<Range, 3> ranges;
  std::array<std::uint32_t, 3> span;
  for (int axis = 0; axis < 3; ++axis) {
    ranges[axis] = {place(box.lo[axis], axis), place(box.hi[axis], axis)};
    span[axis] = ranges[axis].hi.cell - ranges[axis].lo.cell;
  }
  std::uint32_t level = 0;
  for (std::uint32_t longest = *std::max_element(span.begin(), span.end()); longest > kFewCells; longest /= 2)
    ++level;
  std::array<std::uint32_t, 3> first, count;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = ranges[axis].lo.cell >> level;
    count[axis] = (ranges[axis].hi.cell >> level) - first[axis] + 1;
  }
  double least = std::numeric_limits<double>::infinity();
  for_each(count, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    const std::array<std::uint32_t, 3> c{first[0] + i, first[1] + j, first[2] + k};
    least = std::min(least, level == 0 ? least_in_cell(c, ranges) : levels_[level].at(c[0], c[1], c[2]));
  });
  return least * (1 - kSlack);
}

Grid::Blocks Grid::cell_minima() const {
  Blocks cells{cell_counts(shape_), {}};
  for_each(cells.counts, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    double least = std::numeric_limits<double>::infinity();
    for_each({2, 2, 2}, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      least = std::min(least, values_[shape_.index(i + a, j + b, k + c)]);
    });
    cells.least.push_back(least);
  });
  return cells;
}

Grid::Blocks Grid::coarser(const Blocks& fine) {
  Blocks blocks;
  for (int axis = 0; axis < 3; ++axis) blocks.counts[axis] = (fine.counts[axis] + 1) / 2;
  for_each(blocks.counts, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    double least = std::numeric_limits<double>::infinity();
    for_each({2, 2, 2}, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      const std::uint32_t x = 2 * i + a, y = 2 * j + b, z = 2 * k + c;
      if (x < fine.counts[0] && y < fine.counts[1] && z < fine.counts[2])
        least = std::min(least, fine.at(x, y, z));
    });
    blocks.least.push_back(least);
  });
  return blocks;
}

/// Within a cell each partial derivative is an average of the slopes of the four edges along its axis.
double Grid::steepest() const {
  const Vec3 side = shape_.bounds.size();
  double largest_sq = 0;
  for_each(cell_counts(shape_), [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    Vec3 slope;
    for_each({2, 2, 2}, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      const std::array<std::uint32_t, 3> corner{a, b, c};
      for (int axis = 0; axis < 3; ++axis) {
        if (corner[axis] == 1) continue;
        const double from = values_[shape_.index(i + a, j + b, k + c)];
        const double to =
            values_[shape_.index(i + a + (axis == 0), j + b + (axis == 1), k + c + (axis == 2))];
        const double spacing = side[axis] / (shape_.counts[axis] - 1);
        slope[axis] = std::max(slope[axis], std::fabs(to - from) / spacing);
      }
    });
    largest_sq = std::max(largest_sq, norm_sq(slope));
  });
  return std::sqrt(largest_sq) * (1 + kSlack);
}

}  // namespace unsliver::sizing
