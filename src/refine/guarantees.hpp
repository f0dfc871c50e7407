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

/// A point that triggers a size insertion lies within kWitnessSlack s of the domain (section 5 of the design:
/// cells smaller than this that still meet the domain count as if their centre did).
inline constexpr double kWitnessSlack = 0.1;

/// The constant c of Definition 2 for which (1) survives a size insertion: the new vertex lies within
/// r(level) of p and the next coarser level does not fit, so lfs <= c s + kWitnessSlack s + r(level) must
/// stay below the label's budget. Literal Figure 5 (SC only): s < 2 r(SC_j) gives c = a / sqrt 3 - 1/2.
inline constexpr double kFigure5LiteralC = 2.790994448735806 - kWitnessSlack;
/// Both lattices: c = min((a - sqrt(3)/2) 2/sqrt 5, (b - sqrt(5)/4) 2/sqrt 3).
inline constexpr double kFigure5ThriftyC = 3.9364916731037085 - kWitnessSlack;

/// The right-hand side of inequality (1) for a label, in world units.
inline double figure_5_budget(lattice::Level label) {
  return std::ldexp(lattice::is_bcc(label) ? kFigure5B : kFigure5A, lattice::exponent(label));
}

}  // namespace unsliver::refine
