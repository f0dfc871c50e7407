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
#pragma once

#include <cstdint>

#include "unsliver/types.hpp"

namespace unsliver::exact {

/// How many calls each stage decided.
struct StageCounts {
  std::uint64_t filter = 0, small = 0, wide = 0, tie = 0;
};

/// Sign of det(b - a, c - a, d - a): +1 for a positively oriented tetrahedron, 0 when coplanar.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, StageCounts& counts);

/// For positively oriented a, b, c, d: +1 if e is strictly inside their circumsphere, -1 outside, 0 on it.
int insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e, StageCounts& counts);

/// insphere with ties broken by the symbolic perturbation: never 0.
/// Requires: a, b, c, d positively oriented, e distinct from them.
int insphere_perturbed(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                       StageCounts& counts);

/// The power test: insphere with lifted heights |p|^2 - w(p). Weights are integers held in doubles, |w| <
/// 2^96 as exact doubles; +1 if e is below the lifted hyperplane of a..d (in conflict), -1 above, 0 on it.
int power_test(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
               const double (&w)[5], StageCounts& counts);

}  // namespace unsliver::exact
