/// \file
/// A formula's value over a box together with its three partial derivatives and its rounding error.
#pragma once

#include <array>

#include "geom/interval.hpp"

namespace unsliver::geom {

/// What is known of a function over a box.
///
/// `slope[k]` holds every difference quotient of the exact function along axis k between points of the box,
/// so the mean value theorem may be used even where the function has kinks; where it may jump or be
/// undefined, the slopes are everything. `steepness` is a Lipschitz constant of the exact function on the
/// box: at a kink such as the apex of a distance it is far less than the slopes together. `rounding` bounds
/// |computed value - exact value| over the box.
struct Dual {
  Interval value;
  std::array<Interval, 3> slope;
  double steepness = 0;
  double rounding = 0;
};

Dual hull(const Dual& a, const Dual& b);

Dual operator-(const Dual& a);
Dual operator+(const Dual& a, const Dual& b);
Dual operator-(const Dual& a, const Dual& b);
Dual operator*(const Dual& a, const Dual& b);
Dual divide(const Dual& a, const Dual& b);
Dual square(const Dual& a);
Dual power_int(const Dual& a, int n);
Dual power(const Dual& a, const Dual& b);
Dual norm(std::span<const Dual> terms);

Dual abs(const Dual& a);
Dual sqrt(const Dual& a);
Dual cbrt(const Dual& a);
Dual exp(const Dual& a);
Dual log(const Dual& a);
Dual log10(const Dual& a);
Dual sin(const Dual& a);
Dual cos(const Dual& a);
Dual tan(const Dual& a);
Dual asin(const Dual& a);
Dual acos(const Dual& a);
Dual atan(const Dual& a);
Dual atan2(const Dual& y, const Dual& x);
Dual sinh(const Dual& a);
Dual cosh(const Dual& a);
Dual tanh(const Dual& a);
Dual floor(const Dual& a);
Dual ceil(const Dual& a);
Dual sign(const Dual& a);

Dual smaller(const Dual& a, const Dual& b);
Dual larger(const Dual& a, const Dual& b);
Dual less(const Dual& a, const Dual& b);
Dual less_equal(const Dual& a, const Dual& b);
Dual select(const Dual& condition, const Dual& yes, const Dual& no);

}  // namespace unsliver::geom
