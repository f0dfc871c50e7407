/// \file
/// The constants of the theorems, and nothing else.
///
/// Notation (Labelle, section 4.2). A vertex v with label SC_k satisfies lfs(v) <= 2^k a, with label BCC_k
/// lfs(v) <= 2^k b: inequality (1). Theorem 7 turns that into nearest-neighbour distances, hence termination.
#pragma once

#include <cmath>

#include "lattice/level.hpp"

namespace unsliver::refine {

/// Figure 5 (section 4.2.4): a = 2 sqrt 3 + sqrt 5, b = sqrt 3 + sqrt 5.
inline constexpr double kFigure5A = 5.700169592637544;
inline constexpr double kFigure5B = 3.968118785068667;

/// Theorem 7 with these constants: every vertex is at least lfs / 6.701 away from its nearest neighbour.
inline constexpr double kFigure5Grading = 1 / (1 + kFigure5A);

/// Relative slack of the sizing function: a vertex is inserted where the nearest one is farther than (1 -
/// kSizeSlack) s, and within (1 - kSizeSlack) s, so that rounding can neither miss a violation nor push a
/// fitted size one level finer.
inline constexpr double kSizeSlack = 1e-6;

/// A point p that triggers a size insertion lies in the domain, or within kWitnessSlack s of a point a of it:
/// cells this small that still meet the domain count as if their centre did. lfs(w) <= c s(a) + |aw| is then
/// at most c s(p) + |pw| + (1 + c L) kWitnessSlack s, L the Lipschitz constant of s: half a percent of c for
/// L <= 1.
inline constexpr double kWitnessSlack = 1e-3;

/// The constant c of Definition 2 for which (1) survives a size insertion: the new vertex lies within
/// r(level) of p and the next coarser level does not fit, so c s + r(level), with s below the next covering
/// radius, must not exceed the label's budget. Literal Figure 5 (SC only, s < 2 r(SC_j)): c = a / sqrt 3 -
/// 1/2. (Section 4.2.1 leaves out dist(p, w); with it c is smaller.)
inline constexpr double kFigure5LiteralC = 2.77;  // 2.7910 less the witness slack
/// Both lattices: c = min((a - sqrt(3)/2) 2/sqrt 5, (b - sqrt(5)/4) 2/sqrt 3).
inline constexpr double kFigure5ThriftyC = 3.91;  // 3.9365 less the witness slack

/// The right-hand side of inequality (1) for a label, in world units.
inline double figure_5_budget(lattice::Level label) {
  return std::ldexp(lattice::is_bcc(label) ? kFigure5B : kFigure5A, lattice::exponent(label));
}

/// Parent closure (docs/CLOSURE.md), with labels that are canonical levels. A parent u of v in SC_k is in
/// BCC_{k+1} and at most sqrt(2) 2^k away, one of v in BCC_k is in SC_k and sqrt(3)/2 2^k away: (1) survives
/// for a + sqrt(2) <= 2 b and b + sqrt(3)/2 <= a. With equality a = sqrt(3) + sqrt(2), b = sqrt(3)/2 +
/// sqrt(2); neighbours are at least lfs / (1 + a) away, and c is as for Figure 5.
inline constexpr double kClosureA = 3.1462643699419723;
inline constexpr double kClosureB = 2.2802389661575337;
inline constexpr double kClosureC = 1.97;  // 1.9875 less the witness slack
inline constexpr double kClosureGrading = 1 / (1 + kClosureA);
/// The points of SC_45 are vertices whatever the size, and (1) must hold for those that are kept: at most
/// sqrt(3) 2^45 from the domain, whose diagonal is at most sqrt(3) 2^45, in world units. sqrt(3) + c / 2
/// sqrt(3) < 1 + a will do.
inline constexpr double kClosureLargestSize = 0.5;
static_assert(1.7321 * (1 + kClosureC * kClosureLargestSize) < 1 + kClosureA);

inline double closure_budget(lattice::Level level) {
  return std::ldexp(lattice::is_bcc(level) ? kClosureB : kClosureA, lattice::exponent(level));
}

/// Figure 8 (section 5.2.6): alpha = (2 sqrt 3 + 4 rho)(2 sqrt 3 + 2 rho) + 3 sqrt 3 / 2 + 2 rho,
/// a = alpha + sqrt 5 + 5 sqrt 3 + 5 rho, b >= (a + sqrt 5)/2. The alpha that certificates must meet is
/// rounded down, a and b are those that follow from it.
inline constexpr double kFigure8Alpha = 88.18;
inline constexpr double kFigure8A = 108.71;
inline constexpr double kFigure8B = 55.48;

/// Theorem 7 as extended in 5.2.6: 1 / (1 + a).
inline constexpr double kFigure8Grading = 1 / 109.8;

/// The constant c of Definition 2 beside input vertices. The size step takes the coarsest level whose point w
/// has an empty forbidden region; one with r(level) + 2^k rho <= s always has, so s < 2^k (sqrt 3 + 2 rho)
/// for the label taken, and c s + r(level) <= 2^k alpha for c = (alpha - sqrt(3)/2) / (sqrt 3 + 2 rho).
inline constexpr double kFigure8LiteralC = 15.5;  // 15.633 less the witness slack
inline constexpr double kFigure8ThriftyC = 12.4;  // 0.8 of it: see kThriftyHurry

/// Inequality (1) for Figure 8, in two budgets, in units of 2^k with k the exponent of the label's forbidden
/// region. 5.2.5 ends its chain of parents at a vertex with lfs <= 2^k max(b + sqrt 3, alpha), so all
/// vertices but those of types 1.1 and 2 meet the tight one; these two may use the full one.
inline double figure_8_budget(lattice::Level label) {
  return std::ldexp(lattice::is_bcc(label) ? 2 * kFigure8B : kFigure8A, lattice::region_exponent(label));
}
inline double figure_8_tight_budget(lattice::Level label) {
  return std::ldexp(lattice::is_bcc(label) ? kFigure8Alpha + 2.236 : kFigure8Alpha,
                    lattice::region_exponent(label));
}

}  // namespace unsliver::refine
