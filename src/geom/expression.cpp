#include "geom/expression.hpp"

#include "geom/expression_run.hpp"

namespace unsliver::geom {
namespace {

Interval side(const Box3& box, int axis) { return {box.lo[axis], box.hi[axis]}; }

Dual variable(const Box3& box, int axis) {
  Dual d{side(box, axis), {}, 1, 0};
  d.slope[static_cast<std::size_t>(axis)] = {1, 1};
  return d;
}

/// Everything f(p) - f(centre) can be for p in the box.
Interval largest_change(const Dual& f, const Box3& box, const Vec3& centre) {
  const Vec3 reach{std::fmax(centre.x - box.lo.x, box.hi.x - centre.x),
                   std::fmax(centre.y - box.lo.y, box.hi.y - centre.y),
                   std::fmax(centre.z - box.lo.z, box.hi.z - centre.z)};
  const double at_most = f.steepness * norm(reach) * (1 + 8 * kEpsilon);
  Interval change;
  for (int axis = 0; axis < 3; ++axis) {
    const Interval offset = side(box, axis) - Interval::point(centre[axis]);
    if (offset.lo == 0 && offset.hi == 0) continue;
    change = change + f.slope[static_cast<std::size_t>(axis)] * offset;
  }
  return {std::fmax(change.lo, -at_most), std::fmin(change.hi, at_most)};
}

}  // namespace

Expression Expression::parse(const std::string& text) {
  Expression e;
  e.program_ = std::make_shared<const Program>(compile(text));
  e.text_ = text;
  return e;
}

double Expression::at(const Vec3& p) const { return run(*program_, p.x, p.y, p.z); }

Interval Expression::over(const Box3& box, bool* may_be_nan) const {
  const Interval value = run(*program_, side(box, 0), side(box, 1), side(box, 2));
  if (may_be_nan) *may_be_nan = value.may_be_nan;
  return value;
}

Interval Expression::derivative_over(const Box3& box, int axis) const {
  return enclosure_over(box).slope[static_cast<std::size_t>(axis)];
}

Dual Expression::enclosure_over(const Box3& box) const {
  return run(*program_, variable(box, 0), variable(box, 1), variable(box, 2));
}

Interval Expression::tight_over(const Box3& box) const {
  const Dual f = enclosure_over(box);
  if (f.value.may_be_nan || !(f.rounding < kInfinity)) return f.value;
  const Vec3 centre = box.center();
  const Interval mean =
      over({centre, centre}) + largest_change(f, box, centre) + Interval{-f.rounding, f.rounding};
  return {std::fmax(f.value.lo, mean.lo), std::fmin(f.value.hi, mean.hi)};
}

}  // namespace unsliver::geom
