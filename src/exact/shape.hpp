/// \file
/// The expressions of degree 8 whose signs are the quality of a tetrahedron, for doubles and for integers.
///
/// Notation. Corners 0..3; e_i = the edge vector from corner 3 to corner i, i < 3; n_i = the outward normal
/// of the face opposite to corner i, as long as twice its area; l_min = the smallest squared edge. All is
/// made of the products e_i . e_j: those of the normals, G_ij = n_i . n_j, are their minors for i, j < 3
/// (Lagrange's identity), and n_0 + n_1 + n_2 + n_3 = 0 gives the others. The dihedral angle of faces i and j
/// has cos = -G_ij / sqrt(G_ii G_jj), so
///   angle > bound     iff   sign num G_ii G_jj + den G_ij |G_ij| > 0.
/// The circumcentre is X / (2 det) away from corner 3 with X = sum |e_i|^2 n_i and det = det(e_0, e_1, e_2):
///   ratio^2 > bound   iff   den |X|^2 - 4 num det^2 l_min > 0.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "exact/determinants.hpp"
#include "exact/lanes.hpp"
#include "exact/quality_signs.hpp"
#include "exact/wide_int.hpp"

namespace unsliver::exact {

template <class Two, class One>
constexpr Two dot_product(const Row<One>& a, const Row<One>& b) {
  return Two(a.x) * Two(b.x) + Two(a.y) * Two(b.y) + Two(a.z) * Two(b.z);
}

/// v |v|, in a type that holds it.
template <class Square, class T>
Square signed_square(const T& v) {
  if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Lanes>) {
    using std::abs;
    return v * abs(v);
  } else {
    const Square square = Square(v) * Square(v);
    return sign_of(v) < 0 ? -square : square;
  }
}

/// The edge vectors e_0, e_1, e_2.
template <class One>
using Edges = std::array<Row<One>, 3>;

/// A bound as coefficients of the two terms above.
template <class Eight>
struct Coefficients {
  Eight num, den;
  explicit constexpr Coefficients(const CosBound& b) : num(Eight(b.sign * b.num)), den(Eight(b.den)) {}
  explicit constexpr Coefficients(const RatioBound& b) : num(Eight(4 * b.num)), den(Eight(b.den)) {}
};

/// One pair of faces: the terms G_ii G_jj and G_ij |G_ij|.
template <class Eight>
struct FacePair {
  Eight norms, dot;

  /// Its sign is that of angle - bound.
  constexpr Eight excess(const Coefficients<Eight>& bound) const {
    return bound.num * norms + bound.den * dot;
  }
};

/// Two, Four, Eight: number types for values of degree 2, 4, and 6 or 8 in the coordinates. Scalars, not
/// arrays: they stay in registers.
template <class Two, class Four, class Eight>
class Shape {
 public:
  template <class One>
  explicit constexpr Shape(const Edges<One>& e)
      : l0_(lift<Two>(e[0])),
        l1_(lift<Two>(e[1])),
        l2_(lift<Two>(e[2])),
        e01_(dot_product<Two>(e[0], e[1])),
        e02_(dot_product<Two>(e[0], e[2])),
        e12_(dot_product<Two>(e[1], e[2])),
        g00_(minor(l1_, l2_, e12_, e12_)),
        g11_(minor(l0_, l2_, e02_, e02_)),
        g22_(minor(l0_, l1_, e01_, e01_)),
        g01_(minor(e12_, e02_, e01_, l2_)),
        g02_(minor(e01_, e12_, l1_, e02_)),
        g12_(minor(e02_, e01_, e12_, l0_)),
        g03_(-(g00_ + g01_ + g02_)),
        g13_(-(g01_ + g11_ + g12_)),
        g23_(-(g02_ + g12_ + g22_)),
        g33_(-(g03_ + g13_ + g23_)) {}

  /// The pair of the faces opposite to corners i and j.
  FacePair<Eight> pair(std::size_t i, std::size_t j) const {
    const std::array<Four, 4> squares = {g00_, g11_, g22_, g33_};
    const std::array<Four, 6> products = {g01_, g02_, g03_, g12_, g13_, g23_};
    return pair(squares[i], squares[j], products[std::min(i, j) == 0 ? std::max(i, j) - 1 : i + j]);
  }

  template <class Visit>
  void for_each_pair(Visit visit) const {
    visit(pair(g00_, g11_, g01_));
    visit(pair(g00_, g22_, g02_));
    visit(pair(g00_, g33_, g03_));
    visit(pair(g11_, g22_, g12_));
    visit(pair(g11_, g33_, g13_));
    visit(pair(g22_, g33_, g23_));
  }

  /// Its sign is that of (circumradius / shortest edge)^2 - bound.
  constexpr Eight ratio_excess(const Coefficients<Eight>& bound) const {
    return bound.den * center_sq() - bound.num * (Eight(shortest()) * det_sq());
  }
  /// |X|^2 and det^2: the squared circumradius is their ratio over 4.
  constexpr Eight center_sq() const {
    return Eight(l0_) * sum(g00_, l0_, g01_, l1_, g02_, l2_) +
           Eight(l1_) * sum(g01_, l0_, g11_, l1_, g12_, l2_) +
           Eight(l2_) * sum(g02_, l0_, g12_, l1_, g22_, l2_);
  }
  constexpr Eight det_sq() const { return sum(g00_, l0_, g01_, e01_, g02_, e02_); }

  /// The smallest and the largest squared edge.
  constexpr Two shortest() const {
    using std::min;
    return min(min(min(l0_, l1_), min(l2_, l01())), min(l02(), l12()));
  }
  constexpr Two longest() const {
    using std::max;
    return max(max(max(l0_, l1_), max(l2_, l01())), max(l02(), l12()));
  }

 private:
  static constexpr Four minor(const Two& a, const Two& b, const Two& c, const Two& d) {
    return Four(a) * Four(b) - Four(c) * Four(d);
  }
  static FacePair<Eight> pair(const Four& square_i, const Four& square_j, const Four& product) {
    return {Eight(square_i) * Eight(square_j), signed_square<Eight>(product)};
  }
  static constexpr Eight sum(const Four& a, const Two& b, const Four& c, const Two& d, const Four& e,
                             const Two& f) {
    return Eight(a) * Eight(b) + Eight(c) * Eight(d) + Eight(e) * Eight(f);
  }

  constexpr Two l01() const { return l0_ + l1_ - (e01_ + e01_); }
  constexpr Two l02() const { return l0_ + l2_ - (e02_ + e02_); }
  constexpr Two l12() const { return l1_ + l2_ - (e12_ + e12_); }

  Two l0_, l1_, l2_, e01_, e02_, e12_;                              ///< e_i . e_j
  Four g00_, g11_, g22_, g01_, g02_, g12_, g03_, g13_, g23_, g33_;  ///< n_i . n_j
};

using LanesShape = Shape<Lanes, Lanes, Lanes>;
using DoubleShape = Shape<double, double, double>;
using MediumShape = Shape<std::int64_t, std::int64_t, Int128>;
using WideShape = Shape<Int128, Int256, Int512>;

}  // namespace unsliver::exact
