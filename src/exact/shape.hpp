/// \file
/// The expressions of degree 8 whose signs are the quality of a tetrahedron, for doubles and for integers.
///
/// Notation. Corners 0..3; n_i = the outward normal of the face opposite to corner i, as long as twice its
/// area; N_i = |n_i|^2; e_0, e_1, e_2 = the edge vectors from corner 3; l_min = the smallest squared edge.
/// With G = n_i . n_j the dihedral angle of faces i and j has cos = -G / sqrt(N_i N_j), so
///   angle > bound     iff   sign num N_i N_j + den G |G| > 0.
/// The circumcentre is X / (2 det) away from corner 3, X = sum |e_i|^2 n_i and |det| = |e_0 . n_0|, so
///   ratio^2 > bound   iff   den |X|^2 - 4 num det^2 l_min > 0.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "exact/determinants.hpp"
#include "exact/quality_signs.hpp"
#include "exact/wide_int.hpp"

namespace unsliver::exact {

template <class Two, class One>
constexpr Row<Two> cross_product(const Row<One>& a, const Row<One>& b) {
  return {Two(a.y) * Two(b.z) - Two(a.z) * Two(b.y), Two(a.z) * Two(b.x) - Two(a.x) * Two(b.z),
          Two(a.x) * Two(b.y) - Two(a.y) * Two(b.x)};
}

template <class Product, class A, class B>
constexpr Product dot_product(const Row<A>& a, const Row<B>& b) {
  return Product(a.x) * Product(b.x) + Product(a.y) * Product(b.y) + Product(a.z) * Product(b.z);
}

/// v |v|, in a type that holds it.
template <class Square, class T>
constexpr Square signed_square(const T& v) {
  const Square square = Square(v) * Square(v);
  return sign_of(v) < 0 ? -square : square;
}

/// The edge vectors of a tetrahedron: from corner 3 to 0, 1, 2, then 0 to 1, 0 to 2, 1 to 2.
template <class One>
using Edges = std::array<Row<One>, 6>;

/// A bound on an angle or ratio as coefficients of the two terms above.
template <class Eight>
struct Coefficients {
  Eight num, den;
  explicit constexpr Coefficients(const CosBound& b) : num(Eight(b.sign * b.num)), den(Eight(b.den)) {}
  explicit constexpr Coefficients(const RatioBound& b) : num(Eight(4 * b.num)), den(Eight(b.den)) {}
};

/// One pair of faces: the terms N_i N_j and G |G|.
template <class Eight>
struct FacePair {
  Eight norms, dot;

  /// Its sign is that of angle - bound.
  constexpr Eight excess(const Coefficients<Eight>& bound) const {
    return bound.num * norms + bound.den * dot;
  }
};

/// Two, Four, Eight: number types for values of degree 2, 4 and 8 in the coordinates.
template <class One, class Two, class Four, class Eight>
class Shape {
 public:
  explicit constexpr Shape(const Edges<One>& edges)
      : edges_(edges),
        normals_{cross_product<Two>(edges[1], edges[2]), cross_product<Two>(edges[2], edges[0]),
                 cross_product<Two>(edges[0], edges[1]), cross_product<Two>(edges[4], edges[3])} {
    for (std::size_t i = 0; i < 4; ++i) norms_[i] = dot_product<Four>(normals_[i], normals_[i]);
    for (std::size_t i = 0; i < 6; ++i) lengths_[i] = lift<Two>(edges[i]);
  }

  constexpr FacePair<Eight> pair(std::size_t i, std::size_t j) const {
    return {Eight(norms_[i]) * Eight(norms_[j]),
            signed_square<Eight>(dot_product<Four>(normals_[i], normals_[j]))};
  }

  /// Its sign is that of (circumradius / shortest edge)^2 - bound.
  constexpr Eight ratio_excess(const Coefficients<Eight>& bound) const {
    const Row<Four> center = {weighted(&Row<Two>::x), weighted(&Row<Two>::y), weighted(&Row<Two>::z)};
    const Four det = dot_product<Four>(edges_[0], normals_[0]);
    const Eight det_sq = Eight(det) * Eight(det);
    const Two shortest = *std::min_element(lengths_.begin(), lengths_.end());
    return bound.den * dot_product<Eight>(center, center) - bound.num * (det_sq * Eight(shortest));
  }

  /// The largest squared edge.
  constexpr Two longest() const { return *std::max_element(lengths_.begin(), lengths_.end()); }

 private:
  constexpr Four weighted(Two Row<Two>::*axis) const {
    return Four(lengths_[0]) * Four(normals_[0].*axis) + Four(lengths_[1]) * Four(normals_[1].*axis) +
           Four(lengths_[2]) * Four(normals_[2].*axis);
  }

  Edges<One> edges_;
  std::array<Row<Two>, 4> normals_;
  std::array<Four, 4> norms_{};
  std::array<Two, 6> lengths_{};
};

using DoubleShape = Shape<double, double, double, double>;
using MediumShape = Shape<std::int64_t, std::int64_t, std::int64_t, Int128>;
using WideShape = Shape<std::int64_t, Int128, Int256, Int512>;

}  // namespace unsliver::exact
