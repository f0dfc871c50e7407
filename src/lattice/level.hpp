/// \file
/// The nested chain of lattices as one integer (Labelle, section 3; Propositions 2 and 4).
///
/// level 2k = BCC_k, level 2k + 1 = SC_k; BCC_{k+1} < SC_k < BCC_k, so a larger level is a coarser lattice
/// and level + 1 is the next coarser one. Level 1 (SC_0, all integer points) is the finest; kMaxLevel the
/// coarsest. Points are integers held in doubles, |c| < 2^48.
#pragma once

#include "unsliver/types.hpp"

namespace unsliver::lattice {

using Level = int;
inline constexpr Level kMinLevel = 1;   ///< SC_0
inline constexpr Level kMaxLevel = 97;  ///< SC_48

constexpr bool is_bcc(Level level) { return (level & 1) == 0; }
/// The exponent k of SC_k or BCC_k.
constexpr int exponent(Level level) { return level >> 1; }
/// k such that the label's forbidden region is R(v, k): SC_k and BCC_{k+1} share it (Labelle, section 5).
constexpr int region_exponent(Level level) { return (level - 1) >> 1; }

/// e(L): the shortest distance between two points (Proposition 4).
double shortest_distance(Level level);
/// r(L): the radius of the largest empty ball (Proposition 4).
double covering_radius(Level level);

/// Is the integer point p in the lattice?
bool on_lattice(Level level, const Vec3& p);
/// The coarsest level whose lattice holds p; kMaxLevel for the origin.
Level canonical_level(const Vec3& p);
/// The coarsest level with covering_radius(level) <= radius; kMinLevel - 1 if there is none.
Level coarsest_within(double radius);

/// A lattice point nearest to the (real) point p; ties go to the lexicographically smallest.
Vec3 nearest(Level level, const Vec3& p);

}  // namespace unsliver::lattice
