/// \file
/// The forbidden region R(p, k) of Labelle's Definition 6, a cube of half side 2^k (2 + sqrt 6)/4.
#pragma once

#include "lattice/level.hpp"

namespace unsliver::lattice {

/// sigma = (2 + sqrt 6)/4 and rho = sqrt(3) sigma, rounded to nearest.
inline constexpr double kSigma = 1.1123724356957945;
inline constexpr double kRho = 1.9266855757801407;

/// floor(2^k sigma), exactly: integer points q satisfy |q - p|_inf <= 2^k sigma iff <= this. 0 <= k <= 48.
double half_side(int k);

/// Is integer point q in R(p, region_exponent(level))?
bool in_forbidden_region(const Vec3& p, Level level, const Vec3& q);

}  // namespace unsliver::lattice
