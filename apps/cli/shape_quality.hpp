/// \file
/// The quality of a mesh from its shapes and how often each occurs.
#pragma once

#include "unsliver/quality.hpp"
#include "unsliver/verify_stream.hpp"

namespace unsliver::cli {

/// As summarize_quality of the whole mesh, but `worst` names one tetrahedron of each shape, its first corner
/// at the origin.
QualitySummary summarize_quality(const std::vector<TetShape>& shapes, std::size_t worst_count = 5);

}  // namespace unsliver::cli
