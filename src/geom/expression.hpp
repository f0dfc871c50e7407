/// \file
/// A formula in x, y, z that can be evaluated at a point and bounded, soundly, over a box.
#pragma once

#include <memory>
#include <string>

#include "geom/interval.hpp"
#include "unsliver/types.hpp"

namespace unsliver::geom {

class Expression {
 public:
  /// Syntax: numbers, x y z, pi e, + - * / ^ (right associative), unary -, ( ), comparisons < <= > >= (1 or
  /// 0), cond ? a : b, abs min max sqrt cbrt exp log log10 sin cos tan asin acos atan atan2 sinh cosh tanh
  /// floor ceil sign hypot, if(c, a, b), clamp(v, lo, hi). \throws Error kBadOption with the column of the
  /// fault and what was expected.
  static Expression parse(const std::string& text);

  double at(const Vec3& p) const;
  /// Contains at(p) for every p in the box; may be [-inf, inf]. NaN is possible over the box iff may_be_nan
  /// is set.
  Interval over(const Box3& box, bool* may_be_nan = nullptr) const;
  /// Contains every partial derivative along `axis` over the box (forward automatic differentiation with
  /// intervals).
  Interval derivative_over(const Box3& box, int axis) const;
  const std::string& text() const;

 private:
  struct Node;
  std::shared_ptr<const Node> root_;
  std::string text_;
};

}  // namespace unsliver::geom
