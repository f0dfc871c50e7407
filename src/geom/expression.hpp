/// \file
/// A formula in x, y, z that can be evaluated at a point and bounded, soundly, over a box.
#pragma once

#include <memory>
#include <string>

#include "geom/dual.hpp"
#include "geom/interval.hpp"
#include "unsliver/types.hpp"

namespace unsliver::geom {

struct Program;

/// Cheap to copy; const and safe to call from several threads.
///
/// Conventions: a comparison gives 1 or 0; NaN is passed on by every operation, min, max and comparisons
/// included; the zero that divides counts as +0, so 1/0 is +infinity.
class Expression {
 public:
  /// Syntax: numbers, x y z, pi e, + - * / ^ (right associative), unary -, ( ), comparisons < <= > >= (1 or
  /// 0), cond ? a : b, abs min max sqrt cbrt exp log log10 sin cos tan asin acos atan atan2 sinh cosh tanh
  /// floor ceil sign hypot, if(c, a, b), clamp(v, lo, hi). min and max take two arguments or more, hypot two
  /// to eight. From loose to tight: ?:, comparisons, + -, * /, unary -, ^. At most 65536 characters and 200
  /// nested levels. \throws Error kBadOption with the column of the fault and what was expected.
  static Expression parse(const std::string& text);

  double at(const Vec3& p) const;
  /// Contains at(p) for every p in the box; may be [-inf, inf]. NaN is possible over the box only if
  /// may_be_nan is set (here and in the result).
  Interval over(const Box3& box, bool* may_be_nan = nullptr) const;
  /// Contains every partial derivative along `axis` over the box (forward automatic differentiation with
  /// intervals); everything where the function may jump.
  Interval derivative_over(const Box3& box, int axis) const;
  /// Value, all three derivatives and the rounding error of at(), in one pass.
  Dual enclosure_over(const Box3& box) const;
  /// Contains at(p) for every p in the box, as `over`, but closes in on the true range quadratically as the
  /// box shrinks: the intersection with the mean value form. About three times the cost.
  Interval tight_over(const Box3& box) const;
  const std::string& text() const { return text_; }

 private:
  std::shared_ptr<const Program> program_;
  std::string text_;
};

}  // namespace unsliver::geom
