/// The bounds are cut into cells C. A cell is steep if s is not known to be g-Lipschitz in it; with m(C) a
/// lower bound of s there,
///   K(p)  = min over steep C of m(C) + g * distance(p, C),      s'(p) = min(s(p), K(p)).
/// s' <= s plainly. s' is g-Lipschitz, in the Euclidean distance and without a factor: K is, s is so in the
/// cells that are not steep, and in steep ones K <= m(C) <= s rules. (Values limited along a grid's edges
/// and interpolated would be so only to a factor of sqrt(3).) Small cells are needed only where K comes near
/// s; cells whose cone lies above another size's cone are dropped, which keeps K <= s in them.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "sizing/checks.hpp"
#include "sizing/cone_field.hpp"
#include "unsliver/sizing.hpp"

namespace unsliver {
namespace {

constexpr double kCellsAlongLongestSide = 16;
constexpr std::size_t kMostCells = std::size_t{1} << 15;
/// Cells are cut until their bound is this close to the size, or to what the gradation leaves of it.
constexpr double kTolerance = 0.02;

struct Cell {
  Box3 box;
  double bound;      ///< m(C)
  double at_center;  ///< s there
  bool is_steep;
};

class CellCutter {
 public:
  CellCutter(const Sizing& s, double gradation, const Box3& bounds) : s_(s), gradation_(gradation) {
    std::array<int, 3> counts;
    const double side = bounds.longest_side() / kCellsAlongLongestSide;
    for (int axis = 0; axis < 3; ++axis)
      counts[axis] = std::max(1, static_cast<int>(std::lround(bounds.size()[axis] / side)));
    add_parts(bounds, counts);
    drop_dominated();
  }

  /// Cuts the cells that matter most into eight each; false when none need it or none can be had.
  bool refine() {
    const auto worse = [this](const Cell& a, const Cell& b) { return shortfall(a) > shortfall(b); };
    std::stable_sort(cells_.begin(), cells_.end(), worse);
    const std::size_t affordable = (kMostCells - std::min(kMostCells, cells_.size())) / 7;
    std::size_t count = 0;
    while (count < std::min(affordable, cells_.size()) && shortfall(cells_[count]) > kTolerance) ++count;
    const std::vector<Cell> cut(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(count));
    cells_.erase(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(count));
    for (const Cell& c : cut) add_parts(c.box, {2, 2, 2});
    drop_dominated();
    return count > 0;
  }

  const std::vector<Cell>& cells() const { return cells_; }

  double largest_shortfall() const {
    double largest = 0;
    for (const Cell& c : cells_) largest = std::max(largest, shortfall(c));
    return largest;
  }

 private:
  /// An estimate of how far, relative to the bound, s' falls short of the ideal because the cell is not
  /// smaller: by the variation of s in it, or by what the gradation allows across it.
  double shortfall(const Cell& c) const {
    if (!c.is_steep) return 0;
    const double variation = 2 * (c.at_center - c.bound);
    return std::min(variation, gradation_ * c.box.diagonal()) / c.bound;
  }

  void add_parts(const Box3& box, const std::array<int, 3>& counts) {
    const auto cut = [&](int axis, int i) {
      const double t = static_cast<double>(i) / counts[axis];
      return i == counts[axis] ? box.hi[axis] : box.lo[axis] + t * (box.hi[axis] - box.lo[axis]);
    };
    for (int k = 0; k < counts[2]; ++k)
      for (int j = 0; j < counts[1]; ++j)
        for (int i = 0; i < counts[0]; ++i)
          add({{cut(0, i), cut(1, j), cut(2, k)}, {cut(0, i + 1), cut(1, j + 1), cut(2, k + 1)}});
  }

  void add(const Box3& box) {
    const bool is_steep = !(s_.lipschitz_over(box) <= gradation_);
    cells_.push_back({box, s_.lower_bound(box), s_.at(box.center()), is_steep});
  }

  /// s(c) + g |q - c| < m(C) for all q in C, c the centre of another cell D, means by the triangle inequality
  /// that s + g * distance from c is nowhere above the cone of C. If D is not steep, neither is it above the
  /// cone of the first steep cell on the way from c; so some cone that is kept is below that of C.
  void drop_dominated() {
    std::vector<Box3> centers;
    std::vector<double> sizes;
    for (const Cell& c : cells_) {
      centers.push_back({c.box.center(), c.box.center()});
      sizes.push_back(c.at_center);
    }
    const sizing::ConeField from_above(std::move(centers), std::move(sizes), gradation_);
    std::erase_if(cells_, [&](const Cell& c) {
      const double highest = from_above.at(c.box.center(), c.bound) + 0.5 * gradation_ * c.box.diagonal();
      return c.is_steep && (highest <= c.bound * (1 - 1e-12) || std::isinf(c.bound));
    });
  }

  const Sizing& s_;
  double gradation_;
  std::vector<Cell> cells_;
};

class Limited final : public Sizing {
 public:
  Limited(SizingPtr s, sizing::ConeField cones, double gradation, const Box3& bounds, double shortfall)
      : s_(std::move(s)),
        cones_(std::move(cones)),
        gradation_(gradation),
        bounds_(bounds),
        shortfall_(shortfall) {}

  double at(const Vec3& p) const override {
    const Vec3 q = sizing::clamped(p, bounds_);
    return cones_.at(q, s_->at(q));
  }

  double lower_bound(const Box3& box) const override {
    const Box3 inside = sizing::clamped(box, bounds_);
    return cones_.least_over(inside, s_->lower_bound(inside));
  }

  double lipschitz() const override { return gradation_; }

  std::string describe() const override {
    return fmt::format("{}, limited to gradation {}", s_->describe(), gradation_);
  }

  std::vector<std::string> notes() const override {
    std::vector<std::string> all = s_->notes();
    all.push_back(
        fmt::format("the gradation was limited by {} cells of {}: the size is nowhere above the "
                    "ideal limit there and about {:.2g}% below it at most",
                    cones_.size(), sizing::to_text(bounds_), 100 * shortfall_));
    return all;
  }

 private:
  SizingPtr s_;
  sizing::ConeField cones_;
  double gradation_;
  Box3 bounds_;
  double shortfall_;
};

}  // namespace

SizingPtr limit_gradation(SizingPtr s, double g, const Box3& bounds) {
  sizing::require_bounds(bounds);
  sizing::require_positive(g, "The largest gradation");
  if (s->lipschitz() <= g) return s;
  CellCutter cutter(*s, g, bounds);
  while (cutter.refine()) {
  }
  std::vector<Box3> boxes;
  std::vector<double> heights;
  for (const Cell& c : cutter.cells()) {
    if (!c.is_steep) continue;
    boxes.push_back(c.box);
    heights.push_back(c.bound);
  }
  sizing::ConeField cones(std::move(boxes), std::move(heights), g);
  return std::make_shared<Limited>(std::move(s), std::move(cones), g, bounds, cutter.largest_shortfall());
}

}  // namespace unsliver
