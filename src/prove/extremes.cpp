#include "prove/extremes.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "prove/gradient.hpp"

namespace unsliver::prover {
namespace {

using Raw = Enclosure::Raw;

constexpr int kQuarters = 4;
/// Boxes are not split below this side.
constexpr Raw kLeastSide = Raw{1} << (Enclosure::kBits - 18);

/// The width of an end's enclosure is at most this.
constexpr Raw kIrrational = 2;

Enclosure quarters(const Surd& x) { return enclosure_of({x, kQuarters}); }

SurdFraction exact_at(const Quantity& quantity, const Vector<Surd>& p) {
  const Quotient<Surd> q = quantity.at(p, kQuarters);
  return {q.num, q.den};
}

using Box = std::array<Enclosure, 3>;

/// Over the box; nothing where the denominator may vanish.
std::optional<Gradient> over(const Quantity& quantity, const Box& box) {
  const Vector<Gradient> p{Gradient::coordinate(box[0], 0), Gradient::coordinate(box[1], 1),
                           Gradient::coordinate(box[2], 2)};
  const Quotient<Gradient> q = quantity.at(p, 1);
  if (!q.den.value.is_certainly_positive()) return std::nullopt;
  return q.num / q.den;
}

class Search {
 public:
  explicit Search(const Region& region) : region_(region) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lo_[axis] = quarters(region[axis].lo);
      hi_[axis] = quarters(region[axis].hi);
      whole_[axis] = Enclosure::span(lo_[axis], hi_[axis]);
    }
  }

  /// A value that is attained at a corner, rounded down: what boxes must beat.
  void start_from(const Quantity& quantity) {
    for (int c = 0; c < 8; ++c)
      if (const auto g = over(quantity, corner_box(c))) bar_ = std::max(bar_, g->value.lo());
  }

  void run(const Quantity& quantity) { descend(quantity, whole_); }
  Extreme take() { return std::move(result_); }

 private:
  Box corner_box(int c) const {
    const auto end = [&](std::size_t axis) { return (c >> axis & 1) != 0 ? hi_[axis] : lo_[axis]; };
    return {end(0), end(1), end(2)};
  }

  void descend(const Quantity& quantity, Box box) {
    ++result_.boxes;
    const auto g = over(quantity, box);
    if (g && g->value.hi() < bar_) return;
    const bool narrowed = g && narrow(box, *g);
    if (const auto at = corner_of(box)) return compare_at(quantity, *at);
    if (narrowed) return descend(quantity, box);
    split(quantity, box);
  }

  /// Keeps the end of the box that the slope rises to, along each axis where its sign is certain.
  bool narrow(Box& box, const Gradient& g) const {
    bool narrowed = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Enclosure &slope = g.slope[axis], &range = box[axis];
      const bool rises = slope.lo() >= 0, falls = slope.hi() <= 0;
      if ((!rises && !falls) || range.width() <= kIrrational) continue;
      const Enclosure& end = rises ? hi_[axis] : lo_[axis];
      const Raw at = rises ? range.hi() : range.lo();
      const bool is_end = rises ? at == end.hi() : at == end.lo();
      box[axis] = is_end ? end : Enclosure::between(at, at);
      narrowed |= box[axis].width() < range.width();
    }
    return narrowed;
  }

  /// The region's corner that the box has shrunk to.
  std::optional<int> corner_of(const Box& box) const {
    int c = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto is = [&](const Enclosure& end) { return box[axis].lo() == end.lo() && box[axis].hi() == end.hi(); };
      if (is(hi_[axis]))
        c |= 1 << axis;
      else if (!is(lo_[axis]))
        return std::nullopt;
    }
    return c;
  }

  void compare_at(const Quantity& quantity, int c) {
    const SurdFraction value = exact_at(quantity, corner(region_, c));
    if (value < result_.value) return;
    if (result_.value < value) result_.places.clear();
    result_.value = value;
    result_.places.push_back({quantity, c});
  }

  void split(const Quantity& quantity, const Box& box) {
    const auto widest = std::max_element(box.begin(), box.end(), [](const Enclosure& a, const Enclosure& b) {
      return a.width() < b.width();
    });
    if (widest->width() < kLeastSide) {
      result_.is_certain = false;
      return;
    }
    const auto axis = std::size_t(widest - box.begin());
    const Raw half = widest->lo() + widest->width() / 2;
    Box part = box;
    part[axis] = Enclosure::between(widest->lo(), half);
    descend(quantity, part);
    part[axis] = Enclosure::between(half, widest->hi());
    descend(quantity, part);
  }

  const Region& region_;
  Box lo_, hi_, whole_;
  Raw bar_ = std::numeric_limits<Raw>::min();
  Extreme result_;
};

}  // namespace

Extreme largest(const std::vector<Quantity>& quantities, const Region& region) {
  Search search(region);
  for (const Quantity& quantity : quantities) search.start_from(quantity);
  for (const Quantity& quantity : quantities) search.run(quantity);
  return search.take();
}

}  // namespace unsliver::prover
