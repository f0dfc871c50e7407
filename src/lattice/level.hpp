/// \file
/// The nested chain of lattices as one integer (Labelle, section 3; Propositions 2 and 4).
///
/// level 2k = BCC_k, level 2k + 1 = SC_k; BCC_{k+1} < SC_k < BCC_k, so a larger level is a coarser lattice
/// and level + 1 is the next coarser one. Level 1 (SC_0, all integer points) is the finest; kMaxLevel the
/// coarsest. Points are integers held in doubles, |c| < 2^48.
///
/// Notation: k' = region_exponent(level). SC_k' and BCC_{k'+1} are made of integer multiples of 2^k'; the
/// BCC points are those whose three multiples are all even or all odd.
#pragma once

#include <bit>
#include <cstdint>

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

/// 2^k, exactly. Requires -1022 <= k <= 1023.
constexpr double power_of_two(int k) { return std::bit_cast<double>(std::uint64_t(1023 + k) << 52); }

/// sqrt(3)/2 and sqrt(5)/4, rounded to nearest (proved in level.cpp).
inline constexpr double kHalfSqrt3 = 0.8660254037844386;
inline constexpr double kQuarterSqrt5 = 0.5590169943749475;

/// e(L): the shortest distance between two points (Proposition 4).
constexpr double shortest_distance(Level level) {
  return (is_bcc(level) ? kHalfSqrt3 : 1.0) * power_of_two(exponent(level));
}
/// r(L): the radius of the largest empty ball (Proposition 4). Strictly increasing in the level.
constexpr double covering_radius(Level level) {
  return (is_bcc(level) ? kQuarterSqrt5 : kHalfSqrt3) * power_of_two(exponent(level));
}

/// Is the integer point p in the lattice? Requires kMinLevel <= level <= kMaxLevel.
constexpr bool on_lattice(Level level, const Vec3& p) {
  const auto x = std::int64_t(p.x), y = std::int64_t(p.y), z = std::int64_t(p.z);
  const std::int64_t spacing = std::int64_t{1} << region_exponent(level);
  const std::int64_t not_multiple = (x | y | z) & (spacing - 1);
  const std::int64_t mixed_parity = ((x ^ y) | (y ^ z)) & (is_bcc(level) ? spacing : 0);
  return (not_multiple | mixed_parity) == 0;
}

/// The coarsest level whose lattice holds p; kMaxLevel for the origin.
constexpr Level canonical_level(const Vec3& p) {
  const auto x = std::uint64_t(std::int64_t(p.x)), y = std::uint64_t(std::int64_t(p.y)),
             z = std::uint64_t(std::int64_t(p.z));
  if ((x | y | z) == 0) return kMaxLevel;
  const int zeros = std::countr_zero(x | y | z);
  const bool all_odd = ((x & y & z) >> zeros & 1) != 0;
  return 2 * zeros + (all_odd ? 2 : 1);
}

/// The coarsest level with covering_radius(level) <= radius; kMinLevel - 1 if there is none.
Level coarsest_within(double radius);

/// A lattice point nearest to the (real) point p; ties go to the lexicographically smallest. Exact for p on
/// a grid of 2^-3 or coarser; else two points whose distances to p differ by a relative 1e-15 may swap.
Vec3 nearest(Level level, const Vec3& p);

}  // namespace unsliver::lattice
