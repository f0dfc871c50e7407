/// \file
/// What a claim comes to: parts, each with what is claimed and what was found.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "prove/tetrahedron.hpp"
#include "unsliver/prove.hpp"

namespace unsliver::prover {

using Finding = std::vector<ProofPart>;

/// Where the differences are explained.
inline constexpr const char* kDifferences = "docs/decisions/0005-what-the-proofs-found.md";

inline ProofPart part(std::string claimed, std::string found, bool holds, std::string explained_in = "") {
  return {std::move(claimed), std::move(found), holds, std::move(explained_in)};
}

/// "there are 48 tetrahedra"
template <class Count>
ProofPart count_part(const std::string& things, Count claimed, Count found) {
  return part(fmt::format("{} {}", claimed, things), fmt::format("{}", found), claimed == found);
}

/// Extremes that are attained: equality, not bounds.
inline ProofPart shape_part(const std::string& of, const Shape& claimed, const Shape& found) {
  return part(of + text(claimed), text(found),
              claimed.least == found.least && claimed.greatest == found.greatest &&
                  claimed.ratio_sq == found.ratio_sq);
}

}  // namespace unsliver::prover
