/// \file
/// The orientation of four points given as doubles, exactly.
#pragma once

#include <cstdint>

#include "unsliver/types.hpp"

namespace unsliver::verifier {

/// How the signs were decided.
struct SignCounts {
  std::uint64_t exact = 0, filtered = 0;
};

/// Sign of det(b - a, c - a, d - a). Requires: finite.
int orientation_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, SignCounts& counts);

/// Where a point lies relative to a tetrahedron of either orientation.
enum class Side { kOutside, kBoundary, kInside };

/// Exact. A flat tetrahedron has no inside: kOutside.
Side locate_in_tet(const Tet& t, const Vec3& p, SignCounts& counts);

}  // namespace unsliver::verifier
