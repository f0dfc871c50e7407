/// \file
/// What a mesh is held to, in the verifier's words.
#pragma once

#include "unsliver/mesh.hpp"
#include "unsliver/verify.hpp"

namespace unsliver::cli {

inline QualityGuarantee guarantee_of(const QualityLimits& limits) {
  return {limits.min_dihedral_deg, limits.max_dihedral_deg, limits.max_radius_edge};
}

}  // namespace unsliver::cli
