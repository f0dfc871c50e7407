/// \file
/// Signs that are never wrong: orientation, in-sphere and power tests on integer points held in doubles.
///
/// Notation. Coordinates are integers with |c| < 2^48, held in doubles, so every difference of two is an
/// exact double below 2^49. D = the largest difference among the arguments, g = the largest power of two that
/// divides all of them.
///
/// Stages, in order; each decides most of what reaches it, and each is counted:
///   filter  plain double arithmetic with a proven error bound;
///   small   exact cheaply: D/g is so small that the double result was already exact (so 0 means 0), or
///           64/128-bit integers hold every intermediate;
///   wide    256-bit integers, always enough: the budgets are proved by static_assert in predicates.cpp;
///   tie     symbolic perturbation of the lifted heights: the height of the lexicographically i-th largest
///           point is raised by epsilon^i, epsilon infinitesimal (Devillers and Teillaud; CGAL's rule).
///
/// Error bounds. u = 2^-53, gamma_k = k u / (1 - k u); rows are exact differences; n = the norm of a row, and
/// l = n^2 as computed. Every term of a 3x3 determinant passes at most 5 roundings (2 in its minor, a
/// product, 2 sums). The absolute values of a minor's terms add up to at most the product of the planar norms
/// (Cauchy-Schwarz), and |az| n'b n'c + |bz| n'a n'c + |cz| n'a n'b with planar norms n' is at most
/// sqrt(2) na nb nc (Cauchy-Schwarz twice). So
///   |error of orient3d| <= gamma_5 sqrt(2) n1 n2 n3,             error^2 <=  50 u^2 (l1 l2 l3),
///   |error of insphere| <= gamma_11 sqrt(2) (prod n) (sum n),    error^2 <= 968 u^2 (prod l) (sum l);
/// the second because heights pass 3 roundings, the product and the sum 3 more, and (sum n)^2 <= 4 sum l.
/// 52 and 1000 leave 3 percent for gamma against k u and for the roundings of the bound and of the square.
/// Squares save a root and absolute values; they stay below 2^503, and integers cannot underflow.
#pragma once

#include <cstdint>

#include "exact/determinants.hpp"
#include "unsliver/types.hpp"

namespace unsliver::exact {

/// How many calls each stage decided. filter + small + wide is the number of calls; tie counts those of them
/// whose exact sign was 0 and was then replaced by the perturbation's.
struct StageCounts {
  std::uint64_t filter = 0, small = 0, wide = 0, tie = 0;
};

namespace detail {

inline constexpr double kUnitRoundoffSq = 0x1p-106;

inline Row<double> row(const Vec3& p, const Vec3& origin) {
  return {p.x - origin.x, p.y - origin.y, p.z - origin.z};
}

/// The in-sphere determinant in doubles and the square of its error bound.
struct LiftedDeterminant {
  Cofactors<double> cofactors;
  double value, error_sq;
};

inline LiftedDeterminant lifted_determinant(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                                            const Vec3& e) {
  const Row<double> ra = row(a, e), rb = row(b, e), rc = row(c, e), rd = row(d, e);
  const double al = lift<double>(ra), bl = lift<double>(rb), cl = lift<double>(rc), dl = lift<double>(rd);
  const Cofactors<double> m = cofactors<double, double>(ra, rb, rc, rd);
  return {m, combine<double>(m, al, bl, cl, dl),
          1000 * kUnitRoundoffSq * ((al * bl) * (cl * dl)) * ((al + bl) + (cl + dl))};
}

/// The stages behind the filters; `error_sq` is the filter's.
int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double value, double error_sq,
                   StageCounts& counts);
int insphere_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                   const LiftedDeterminant& filter, StageCounts& counts);
int insphere_perturbed_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                             const LiftedDeterminant& filter, StageCounts& counts);

}  // namespace detail

/// Sign of det(b - a, c - a, d - a): +1 for a positively oriented tetrahedron, 0 when coplanar.
inline int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, StageCounts& counts) {
  const Row<double> rb = detail::row(b, a), rc = detail::row(c, a), rd = detail::row(d, a);
  const double value = determinant<double, double>(rb, rc, rd);
  const double error_sq =
      52 * detail::kUnitRoundoffSq * (lift<double>(rb) * lift<double>(rc) * lift<double>(rd));
  if (value * value > error_sq) [[likely]] {
    ++counts.filter;
    return value > 0 ? 1 : -1;
  }
  return detail::orient3d_exact(a, b, c, d, value, error_sq, counts);
}

/// For positively oriented a, b, c, d: +1 if e is strictly inside their circumsphere, -1 outside, 0 on it.
inline int insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                    StageCounts& counts) {
  const detail::LiftedDeterminant filter = detail::lifted_determinant(a, b, c, d, e);
  if (filter.value * filter.value > filter.error_sq) [[likely]] {
    ++counts.filter;
    return filter.value > 0 ? 1 : -1;
  }
  return detail::insphere_exact(a, b, c, d, e, filter, counts);
}

/// insphere with ties broken by the symbolic perturbation: never 0.
/// Requires: a, b, c, d positively oriented, e distinct from them.
inline int insphere_perturbed(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                              StageCounts& counts) {
  const detail::LiftedDeterminant filter = detail::lifted_determinant(a, b, c, d, e);
  if (filter.value * filter.value > filter.error_sq) [[likely]] {
    ++counts.filter;
    return filter.value > 0 ? 1 : -1;
  }
  return detail::insphere_perturbed_exact(a, b, c, d, e, filter, counts);
}

/// The power test: insphere with lifted heights |p|^2 - w(p). Weights are integers held in doubles, |w| <
/// 2^96 as exact doubles; +1 if e is below the lifted hyperplane of a..d (in conflict), -1 above, 0 on it.
int power_test(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
               const double (&w)[5], StageCounts& counts);

}  // namespace unsliver::exact
