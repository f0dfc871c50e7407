/// \file
/// Is a tetrahedron bad? Decided exactly where rounding could decide (degree 8, 512 bits in the last stage).
///
/// Labelle's bounds are attained exactly on lattices (cos^2 = 3/4 at 30 degrees, cos^2 = 1/2 at 135,
/// ratio^2 = 5/4), so a tetrahedron AT a bound must not be called bad: squares are compared, as rationals.
#pragma once

#include <cstdint>
#include <span>

#include "exact/predicates.hpp"
#include "unsliver/types.hpp"

namespace unsliver::exact {

/// cos(angle) = sign * sqrt(num / den), num and den below 2^20.
struct CosBound {
  int sign = 1;  ///< +1 for angles below 90 degrees, -1 above, 0 at 90
  std::int64_t num = 3, den = 4;
};

/// A ratio squared, num / den, both below 2^20.
struct RatioBound {
  std::int64_t num = 5, den = 4;
};

/// What "bad" means.
struct QualityBounds {
  CosBound min_dihedral{1, 3, 4};    ///< 30 degrees
  CosBound max_dihedral{-1, 1, 2};   ///< 135 degrees
  RatioBound max_radius_edge{5, 4};  ///< (circumradius / shortest edge)^2
};

/// The rational of at most 20 bits nearest to cos^2(degrees) that does not demand more than asked: `is_min`
/// rounds the angle down, else up. Requires: 0 < degrees < 180. Exact for 30, 45, 60, 90, 120, 135, 150: a
/// rational within 2^-48 of what was asked, relatively, counts as equal to it.
CosBound cos_bound(double degrees, bool is_min);

/// The rational of at most 20 bits for ratio^2, rounded up (never demands more). Exact for sqrt(5)/2, by the
/// same rule. Requires: 0 < ratio < 1000.
RatioBound ratio_bound(double ratio);

/// Sign of (dihedral angle between the faces opposite to corners i and j) - bound, i != j. t is positively
/// oriented with integer coordinates, differences below 2^49.
int compare_dihedral(const Tet& t, int i, int j, const CosBound& bound, StageCounts& counts);

/// Sign of (circumradius / shortest edge)^2 - bound.
int compare_radius_edge(const Tet& t, const RatioBound& bound, StageCounts& counts);

/// Of a tetrahedron, as judge() finds it.
struct Judgement {
  bool is_bad;       ///< exact
  double radius_sq;  ///< the squared circumradius as doubles give it: anything where the tetrahedron is flat
};

/// Bad: some dihedral angle is below the minimum or above the maximum, or the radius-edge ratio is above its
/// bound.
Judgement judge(const Tet& t, const QualityBounds& bounds, StageCounts& counts);

/// The same of each, in the time of a third.
/// Requires: as many judgements as tetrahedra.
void judge(std::span<const Tet> tets, const QualityBounds& bounds, StageCounts& counts,
           std::span<Judgement> judgements);

inline bool is_bad(const Tet& t, const QualityBounds& bounds, StageCounts& counts) {
  return judge(t, bounds, counts).is_bad;
}

}  // namespace unsliver::exact
