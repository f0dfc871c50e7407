/// \file
/// The caller's quality demands, checked against what the theorems back, as exact bounds.
#pragma once

#include "exact/quality_signs.hpp"
#include "unsliver/refine.hpp"

namespace unsliver::refine {

/// \throws Error kBadOption where a demand is stricter than the guarantee or not a number.
exact::QualityBounds quality_bounds(const MeshOptions& options, bool with_input_vertices);

}  // namespace unsliver::refine
