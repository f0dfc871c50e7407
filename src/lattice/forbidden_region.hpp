/// \file
/// The forbidden region R(p, k) of Labelle's Definition 6, a cube of half side 2^k (2 + sqrt 6)/4.
#pragma once

#include <cmath>
#include <cstdint>

#include "lattice/level.hpp"

namespace unsliver::lattice {

/// sigma = (2 + sqrt 6)/4 and rho = sqrt(3) sigma, rounded to nearest.
inline constexpr double kSigma = 1.1123724356957945;
inline constexpr double kRho = 1.92668557556426;

/// floor(2^48 sigma) (proved in forbidden_region.cpp). Its leading bits are floor(2^k sigma) for every
/// smaller k, because floor(floor(x) / 2^n) = floor(x / 2^n).
inline constexpr std::int64_t kSigmaBits = 313'105'005'431'049;

/// floor(2^k sigma), exactly: integer points q satisfy |q - p|_inf <= 2^k sigma iff <= this. 0 <= k <= 48.
constexpr double half_side(int k) { return double(kSigmaBits >> (48 - k)); }

/// Is integer point q in R(p, region_exponent(level))?
inline bool in_forbidden_region(const Vec3& p, Level level, const Vec3& q) {
  const double half = half_side(region_exponent(level));
  return std::abs(q.x - p.x) <= half && std::abs(q.y - p.y) <= half && std::abs(q.z - p.z) <= half;
}

}  // namespace unsliver::lattice
