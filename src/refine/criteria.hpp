/// \file
/// The caller's quality demands, checked against what the theorems back, as exact bounds.
#pragma once

#include "exact/quality_signs.hpp"
#include "unsliver/refine.hpp"

namespace unsliver::refine {

/// The ratio asked for: the least that is proven where 0 was.
inline double max_radius_edge(const MeshOptions& options, bool with_input_vertices) {
  return options.max_radius_edge == 0 ? least_radius_edge(with_input_vertices) : options.max_radius_edge;
}

/// \throws Error kBadOption where a demand is stricter than the guarantee or not a number.
exact::QualityBounds quality_bounds(const MeshOptions& options, bool with_input_vertices);

}  // namespace unsliver::refine
