#include "domain/side_grid.hpp"

#include <cmath>

#include "geom/triangle_shape.hpp"

namespace unsliver::domain {
namespace {

constexpr std::int8_t kMostSteps = 120;
/// Coordinates in units of a cell err by far less than this.
constexpr double kMargin = 1e-9;

/// A triangle in units of cells: its box and its plane, enough to miss most cells it does not meet.
struct CellTriangle {
  Box3 box;
  Vec3 normal;
  double offset = 0;

  bool may_meet(const Vec3& center, const Vec3& half) const {
    for (int axis = 0; axis < 3; ++axis)
      if (box.lo[axis] > center[axis] + half[axis] || box.hi[axis] < center[axis] - half[axis]) return false;
    const double reach =
        std::abs(normal.x) * half.x + std::abs(normal.y) * half.y + std::abs(normal.z) * half.z;
    return std::abs(dot(normal, center) - offset) <= reach;
  }
};

CellTriangle cell_triangle(const geom::Triangle& t) {
  const Vec3 area = geom::area_vector(t);
  const double size = norm(area);
  // A normal that is mostly rounding is left out: the plane then never separates.
  const Box3 box = geom::bounding_box(t);
  const double side = box.longest_side();
  const Vec3 normal = size > 1e-6 * side * side ? (1 / size) * area : Vec3{};
  return {box, normal, dot(normal, t[0])};
}

double cell_size(const Box3& bounds, std::size_t triangles) {
  const double cells = std::clamp(16.0 * static_cast<double>(triangles), 32768.0, 4194304.0);
  const double longest = bounds.longest_side();
  double volume = 1;
  for (int axis = 0; axis < 3; ++axis) volume *= std::max(bounds.size()[axis] / longest, 1e-2);
  return longest * std::cbrt(volume / cells);
}

}  // namespace

/// Splits the grid into blocks that no triangle meets, and asks for the side of each.
class SideGrid::Filler {
 public:
  Filler(SideGrid& grid, const TriangleMesh& surface, const SurfaceRegion& region)
      : grid_(grid), region_(region) {
    const auto corner = [&](VertexId v) { return grid.in_cells(surface.points[v]); };
    for (const auto& t : surface.triangles)
      triangles_.push_back(cell_triangle({corner(t[0]), corner(t[1]), corner(t[2])}));
  }

  void fill(const Block& block, const std::vector<std::uint32_t>& candidates) const {
    const std::vector<std::uint32_t> present = meeting(block, candidates);
    if (present.empty()) return label(block);
    if (length(block, longest_axis(block)) == 1) return;
    const auto [low, high] = halves(block);
    fill(low, present);
    fill(high, present);
  }

  std::vector<std::uint32_t> all() const {
    std::vector<std::uint32_t> ids(triangles_.size());
    for (std::uint32_t i = 0; i < ids.size(); ++i) ids[i] = i;
    return ids;
  }

 private:
  static int length(const Block& block, int axis) { return block.last[axis] - block.first[axis]; }

  static int longest_axis(const Block& block) {
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
      if (length(block, axis) > length(block, longest)) longest = axis;
    return longest;
  }

  static std::array<Block, 2> halves(const Block& block) {
    const int axis = longest_axis(block);
    std::array<Block, 2> parts{block, block};
    parts[0].last[axis] = parts[1].first[axis] = block.first[axis] + length(block, axis) / 2;
    return parts;
  }

  static Vec3 corner(const Index& i) {
    return {static_cast<double>(i[0]), static_cast<double>(i[1]), static_cast<double>(i[2])};
  }

  std::vector<std::uint32_t> meeting(const Block& block, const std::vector<std::uint32_t>& candidates) const {
    const Box3 box{corner(block.first), corner(block.last)};
    const Vec3 center = box.center(), half = 0.5 * box.size() + Vec3{kMargin, kMargin, kMargin};
    std::vector<std::uint32_t> present;
    for (const std::uint32_t t : candidates)
      if (triangles_[t].may_meet(center, half)) present.push_back(t);
    return present;
  }

  void label(const Block& block) const {
    const Side side = side_of(block);
    if (side == Side::kUnknown) return label_halves(block);
    for (int z = block.first[2]; z < block.last[2]; ++z)
      for (int y = block.first[1]; y < block.last[1]; ++y)
        for (int x = block.first[0]; x < block.last[0]; ++x)
          grid_.cells_[grid_.at({x, y, z})] = static_cast<std::int8_t>(side);
  }

  /// The winding number varies too much over the block: parts of it may yet be certain.
  void label_halves(const Block& block) const {
    if (length(block, longest_axis(block)) == 1) return;
    const auto [low, high] = halves(block);
    label(low);
    label(high);
  }

  Side side_of(const Block& block) const {
    if (region_.is_closed()) {
      const Side known = side_of_neighbour(block);
      if (known != Side::kUnknown) return known;
    }
    const Vec3 low = corner(block.first), high = corner(block.last);
    const Vec3 center = grid_.bounds_.lo + (0.5 * grid_.cell_) * (low + high);
    const Side side = region_.side_around(center, (0.5 + kMargin) * grid_.cell_ * norm(high - low));
    const bool beyond = !grid_.bounds_.contains(grid_.bounds_.lo + grid_.cell_ * high);
    return side == Side::kInside && beyond ? Side::kUnknown : side;
  }

  /// Of a cell that shares a face with the block, both free of triangles: then both are on one side.
  Side side_of_neighbour(const Block& block) const {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int step : {block.first[axis] - 1, block.last[axis]}) {
        if (step < 0 || step >= grid_.count_[axis]) continue;
        Index next = block.first;
        next[axis] = step;
        const std::int8_t value = grid_.cells_[grid_.at(next)];
        if (value != 0) return static_cast<Side>(value);
      }
    }
    return Side::kUnknown;
  }

  SideGrid& grid_;
  const SurfaceRegion& region_;
  std::vector<CellTriangle> triangles_;
};

SideGrid::SideGrid(const TriangleMesh& surface, const Box3& bounds, const SurfaceRegion& region)
    : bounds_(bounds), cell_(cell_size(bounds, surface.triangles.size())) {
  for (int axis = 0; axis < 3; ++axis)
    count_[axis] = static_cast<int>(std::floor(bounds.size()[axis] / cell_)) + 1;
  cells_.assign(at({0, 0, count_[2]}), 0);
  const Filler filler(*this, surface, region);
  filler.fill({{0, 0, 0}, count_}, filler.all());
  measure_steps();
}

/// Two sweeps of the chessboard metric: exact, for steps to any of 26 neighbours cost 1.
void SideGrid::measure_steps() {
  for (std::int8_t& cell : cells_) cell = static_cast<std::int8_t>(cell * kMostSteps);
  sweep(1);
  sweep(-1);
}

void SideGrid::sweep(int direction) {
  const auto steps = [&](const Index& i, bool inside) {
    for (int axis = 0; axis < 3; ++axis)
      if (i[axis] < 0 || i[axis] >= count_[axis]) return inside ? 0 : static_cast<int>(kMostSteps);
    return std::abs(static_cast<int>(cells_[at(i)]));
  };
  const auto visit = [&](const Index& i) {
    std::int8_t& cell = cells_[at(i)];
    if (cell == 0) return;
    const bool inside = cell < 0;
    int least = std::abs(static_cast<int>(cell));
    for (int n = 0; n < 13; ++n) {  // the neighbours already visited: 13 of 26
      const Index offset{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
      Index next;
      for (int axis = 0; axis < 3; ++axis) next[axis] = i[axis] + direction * offset[axis];
      least = std::min(least, steps(next, inside) + 1);
    }
    cell = static_cast<std::int8_t>(inside ? -least : least);
  };
  const Index first{direction > 0 ? 0 : count_[0] - 1, direction > 0 ? 0 : count_[1] - 1,
                    direction > 0 ? 0 : count_[2] - 1};
  for (int z = 0; z < count_[2]; ++z)
    for (int y = 0; y < count_[1]; ++y)
      for (int x = 0; x < count_[0]; ++x)
        visit({first[0] + direction * x, first[1] + direction * y, first[2] + direction * z});
}

double SideGrid::clearance(const Vec3& p) const {
  const Vec3 place = in_cells(p);
  Index i;
  double to_side = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::floor(place[axis]);
    if (!(low >= 0 && low < count_[axis])) return 0;
    i[axis] = static_cast<int>(low);
    to_side = std::min({to_side, place[axis] - low, low + 1 - place[axis]});
  }
  const int steps = cells_[at(i)];
  if (steps == 0) return 0;
  const double radius = cell_ * std::max(0.0, std::abs(steps) - 1 + to_side - kMargin);
  return steps < 0 ? -radius : radius;
}

double SideGrid::inside_volume() const {
  double cells = 0;
  for (const std::int8_t cell : cells_) cells += cell < 0 ? 1 : cell == 0 ? 0.5 : 0;
  return cells * cell_ * cell_ * cell_;
}

}  // namespace unsliver::domain
