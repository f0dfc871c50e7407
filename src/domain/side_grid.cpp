#include "domain/side_grid.hpp"

#include <algorithm>
#include <cmath>

#include "geom/triangle_shape.hpp"

namespace unsliver::domain {
namespace {

constexpr std::int8_t kMostSteps = 120;
/// Stands for the steps of a cell without triangles whose side is not known yet.
constexpr std::int8_t kFree = 2;
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

/// Splits the grid into blocks that no triangle meets. About an open surface each is asked for its side;
/// about a closed one those that hang together are alike, and one of them is asked.
class SideGrid::Filler {
 public:
  Filler(SideGrid& grid, const TriangleMesh& surface, const SurfaceRegion& region)
      : grid_(grid), region_(region) {
    const auto corner = [&](VertexId v) { return grid.in_cells(surface.points[v]); };
    for (const auto& t : surface.triangles)
      triangles_.push_back(cell_triangle({corner(t[0]), corner(t[1]), corner(t[2])}));
  }

  void fill(const Block& block, const std::vector<std::uint32_t>& candidates) {
    const std::vector<std::uint32_t> present = meeting(block, candidates);
    if (present.empty()) return region_.is_closed() ? set_free(block) : label(block);
    if (length(block, longest_axis(block)) == 1) return;
    const auto [low, high] = halves(block);
    fill(low, present);
    fill(high, present);
  }

  /// Decides the free cells; what is not certain of a closed surface stays undecided.
  void flood() {
    const auto volume = [](const Block& b) {
      return std::int64_t{length(b, 0)} * length(b, 1) * length(b, 2);
    };
    std::stable_sort(free_.begin(), free_.end(),
                     [&](const Block& a, const Block& b) { return volume(a) > volume(b); });
    for (const Block& block : free_)
      if (grid_.cells_[grid_.at(block.first)].steps == kFree) flood_from(block);
    for (Cell& cell : grid_.cells_)
      if (cell.steps == kFree) cell = {};
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
    const Cell cell = open_cell(block);
    if (cell.steps == 0) return label_halves(block);
    set(block, cell);
  }

  void set(const Block& block, const Cell& cell) const {
    for (int z = block.first[2]; z < block.last[2]; ++z)
      for (int y = block.first[1]; y < block.last[1]; ++y)
        for (int x = block.first[0]; x < block.last[0]; ++x) grid_.cells_[grid_.at({x, y, z})] = cell;
  }

  void set_free(const Block& block) {
    free_.push_back(block);
    set(block, {kFree, 0});
  }

  /// The winding number varies too much over the block: parts of it may yet be certain.
  void label_halves(const Block& block) const {
    if (length(block, longest_axis(block)) == 1) return;
    const auto [low, high] = halves(block);
    label(low);
    label(high);
  }

  Vec3 center_of(const Block& block) const {
    return grid_.bounds_.lo + (0.5 * grid_.cell_) * (corner(block.first) + corner(block.last));
  }

  Cell open_cell(const Block& block) const {
    const Vec3 high = corner(block.last);
    const double diagonal = grid_.cell_ * norm(high - corner(block.first));
    const Side side = region_.side_around(center_of(block), (0.5 + kMargin) * diagonal);
    const bool beyond = !grid_.bounds_.contains(grid_.bounds_.lo + grid_.cell_ * high);
    if (side == Side::kInside && beyond) return {};
    return {static_cast<std::int8_t>(side), 0};
  }

  Cell closed_cell(const Block& block) const {
    const double winding = region_.winding_number(center_of(block)), whole = std::round(winding);
    if (std::abs(winding - whole) > 0.1 || std::abs(whole) > 100) return {};
    return {static_cast<std::int8_t>(whole > 0 ? Side::kInside : Side::kOutside),
            static_cast<std::int8_t>(whole)};
  }

  void flood_from(const Block& block) const {
    const Cell cell = closed_cell(block);
    if (cell.steps == 0) return;
    std::vector<Index> edge{block.first};
    grid_.cells_[grid_.at(block.first)] = cell;
    while (!edge.empty()) {
      const Index from = edge.back();
      edge.pop_back();
      for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          Index next = from;
          next[axis] += step;
          if (!grid_.in_grid(next) || grid_.cells_[grid_.at(next)].steps != kFree) continue;
          grid_.cells_[grid_.at(next)] = cell;
          edge.push_back(next);
        }
    }
  }

  SideGrid& grid_;
  const SurfaceRegion& region_;
  std::vector<CellTriangle> triangles_;
  std::vector<Block> free_;
};

SideGrid::SideGrid(const TriangleMesh& surface, const Box3& bounds, const SurfaceRegion& region)
    : region_(region), bounds_(bounds), cell_(cell_size(bounds, surface.triangles.size())) {
  for (int axis = 0; axis < 3; ++axis)
    count_[axis] = static_cast<int>(std::floor(bounds.size()[axis] / cell_)) + 1;
  cells_.assign(at({0, 0, count_[2]}), {});
  Filler filler(*this, surface, region);
  filler.fill({{0, 0, 0}, count_}, filler.all());
  filler.flood();
  measure_steps();
}

/// Two sweeps of the chessboard metric: exact, for steps to any of 26 neighbours cost 1.
void SideGrid::measure_steps() {
  for (Cell& cell : cells_) cell.steps = static_cast<std::int8_t>(cell.steps * kMostSteps);
  sweep(1);
  sweep(-1);
}

void SideGrid::sweep(int direction) {
  const auto steps = [&](const Index& i, bool inside) {
    if (!in_grid(i)) return inside ? 0 : static_cast<int>(kMostSteps);
    return std::abs(static_cast<int>(cells_[at(i)].steps));
  };
  const auto visit = [&](const Index& i) {
    std::int8_t& cell = cells_[at(i)].steps;
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
  const int steps = cells_[at(i)].steps;
  if (steps == 0) return 0;
  const double radius = cell_ * std::max(0.0, std::abs(steps) - 1 + to_side - kMargin);
  return steps < 0 ? -radius : radius;
}

/// The winding number at p by a straight way to cell i, if that is decided and the way is not ambiguous.
std::optional<int> SideGrid::winding_by_way_of(const Index& i, const Vec3& p) const {
  if (!in_grid(i) || cells_[at(i)].steps == 0) return std::nullopt;
  // Off the centre in all coordinates, for surfaces that are aligned with the grid.
  const Vec3 goal = bounds_.lo + cell_ * Vec3{i[0] + 0.5327, i[1] + 0.4459, i[2] + 0.5718};
  const std::optional<int> gain = region_.tree().winding_gain(goal, p);
  if (!gain) return std::nullopt;
  return cells_[at(i)].winding + *gain;
}

bool SideGrid::holds(const Vec3& p) const {
  const Vec3 place = in_cells(p);
  const Index home{static_cast<int>(place.x), static_cast<int>(place.y), static_cast<int>(place.z)};
  if (in_grid(home) && cells_[at(home)].steps != 0) return cells_[at(home)].steps < 0;
  if (!region_.is_closed()) return region_.holds(p);
  constexpr int kFarthest = 3;
  for (int ring = 1; ring <= kFarthest; ++ring)
    for (int z = -ring; z <= ring; ++z)
      for (int y = -ring; y <= ring; ++y)
        for (int x = -ring; x <= ring; ++x) {
          if (std::max({std::abs(x), std::abs(y), std::abs(z)}) < ring) continue;
          const auto winding = winding_by_way_of({home[0] + x, home[1] + y, home[2] + z}, p);
          if (winding) return *winding > 0;
        }
  return region_.holds(p);
}

double SideGrid::inside_volume() const {
  double cells = 0;
  for (const Cell& cell : cells_) cells += cell.steps < 0 ? 1 : cell.steps == 0 ? 0.5 : 0;
  return cells * cell_ * cell_ * cell_;
}

}  // namespace unsliver::domain
