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
    const auto g = over(quantity, box);
    if (g && (g->value.hi() < bar_ || reach_from_middle(quantity, box, *g) < bar_)) return;
    const bool narrowed = g && narrow(box, *g);
    if (const auto at = corner_of(box)) return compare_at(quantity, *at);
    if (narrowed) return descend(quantity, box);
    if (const auto edge = edge_of(box); edge && falls_along(quantity, *edge))
      return compare_at(quantity, edge->corner);
    split(quantity, box);
  }

  /// An upper bound over the box by the mean value theorem: sharper than g's own where the box is small.
  static Raw reach_from_middle(const Quantity& quantity, const Box& box, const Gradient& g) {
    Box middle;
    Enclosure reach = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Raw at = box[axis].lo() + box[axis].width() / 2;
      middle[axis] = Enclosure::between(at, at);
      reach = reach + g.slope[axis] * (box[axis] - middle[axis]);
    }
    const auto there = over(quantity, middle);
    return there ? (there->value + reach).hi() : std::numeric_limits<Raw>::max();
  }

  /// Keeps the end of the box that the slope rises to, along each axis where its sign is certain.
  bool narrow(Box& box, const Gradient& g) const {
    bool narrowed = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Enclosure slope = g.slope[axis], range = box[axis];
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
      const auto is = [&](const Enclosure& end) {
        return box[axis].lo() == end.lo() && box[axis].hi() == end.hi();
      };
      if (is(hi_[axis]))
        c |= 1 << axis;
      else if (!is(lo_[axis]))
        return std::nullopt;
    }
    return c;
  }

  /// A box that is a piece of one of the region's edges.
  struct Edge {
    int corner, axis;
    Raw length;
  };

  /// The piece from a corner that the box has shrunk to.
  std::optional<Edge> edge_of(const Box& box) const {
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = std::size_t(axis);
      for (const Enclosure& end : {lo_[i], hi_[i]}) {
        if (box[i].lo() != end.lo() && box[i].hi() != end.hi()) continue;
        Box shrunk = box;
        shrunk[i] = end;
        if (const auto c = corner_of(shrunk)) return Edge{*c, axis, box[i].width()};
      }
    }
    return std::nullopt;
  }

  /// Is the quantity greatest at the corner, on this piece? Where its slope vanishes at the corner, no
  /// enclosure of the slope tells. With u the distance from the corner and v the value there, v den(u) -
  /// num(u) is a polynomial of degree 4 that vanishes at 0, known from five places: its first coefficient
  /// must outweigh the others.
  bool falls_along(const Quantity& quantity, const Edge& edge) const {
    constexpr int kSteps = 1 << 10;  // of u, in a quarter
    const SurdFraction v = exact_at(quantity, corner(region_, edge.corner));
    if (v.num.sign() <= 0) return false;  // x |x| is below the polynomial x^2 where x < 0, not below -x^2
    const int inward = (edge.corner >> edge.axis & 1) != 0 ? -1 : 1;
    std::array<Surd, 5> f;
    for (int n = 0; n < 5; ++n) {
      Vector<Surd> p = Surd(kSteps) * corner(region_, edge.corner);
      Surd& coordinate = edge.axis == 0 ? p.x : edge.axis == 1 ? p.y : p.z;
      coordinate = coordinate + Surd(n * inward);
      const Quotient<Surd> q = quantity.at(p, kQuarters * kSteps);
      if (q.num.sign() != v.num.sign()) return false;
      f[std::size_t(n)] = v.num * q.den - v.den * q.num;
    }
    const Raw steps = (edge.length * kQuarters >> Enclosure::kBits) * kSteps + kSteps;
    return is_nonnegative(coefficients(f), int(steps));
  }

  /// 24 times those of u, ..., u^4, by Newton's forward differences.
  static std::array<Surd, 4> coefficients(std::array<Surd, 5> f) {
    for (std::size_t order = 1; order < 5; ++order)
      for (std::size_t n = 4; n >= order; --n) f[n] = f[n] - f[n - 1];
    return {Surd(24) * f[1] - Surd(12) * f[2] + Surd(8) * f[3] - Surd(6) * f[4],
            Surd(12) * f[2] - Surd(12) * f[3] + Surd(11) * f[4], Surd(4) * f[3] - Surd(6) * f[4], f[4]};
  }

  /// For 0 <= u <= most, certainly.
  static bool is_nonnegative(const std::array<Surd, 4>& c, int most) {
    const auto first = std::find_if(c.begin(), c.end(), [](const Surd& x) { return x.sign() != 0; });
    if (first == c.end()) return true;
    Surd others = 0, power = 1;
    for (auto next = first + 1; next != c.end(); ++next) {
      power = Surd(most) * power;
      others = others + (next->sign() < 0 ? -*next : *next) * power;
    }
    return others < *first;
  }

  void compare_at(const Quantity& quantity, int c) {
    const SurdFraction value = exact_at(quantity, corner(region_, c));
    if (value < result_.value) return;
    if (result_.value < value) result_.places.clear();
    result_.value = value;
    result_.places.push_back({quantity, c});
  }

  void split(const Quantity& quantity, const Box& box) {
    const auto widest = std::max_element(
        box.begin(), box.end(), [](const Enclosure& a, const Enclosure& b) { return a.width() < b.width(); });
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
