/// \file
/// Checks that the readers of points share.
#pragma once

#include <string>

#include "io/scanner.hpp"
#include "unsliver/points.hpp"

namespace unsliver::io {

/// Error kBadInput when there is no point, kLimit when a mesh cannot number them.
void require_points(const PointSet& set, const std::string& name);

/// A size as the file gives it in `word`. Error kFormat or kBadInput unless it is finite and positive.
double to_size(const Scanner& scanner, std::string_view word, std::string_view what);

}  // namespace unsliver::io
