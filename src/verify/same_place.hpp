/// \file
/// Two vertices at one place.
#pragma once

#include <bit>

#include "verify/report.hpp"

namespace unsliver::verifier {

/// Equal for points that compare equal, 0 and -0 included.
inline std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t h = 0;
  for (int axis = 0; axis < 3; ++axis) {
    h = (h ^ std::bit_cast<std::uint64_t>(p[axis] + 0.0)) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

/// Finding "conformity": vertices a and b are both at p.
inline void find_coincident(Reporter& reporter, std::int64_t a, std::int64_t b, const Vec3& p) {
  reporter.find("conformity", {a, b}, [&] {
    return "vertices " + std::to_string(a) + " and " + std::to_string(b) + " are both at " + full(p);
  });
}

}  // namespace unsliver::verifier
