/// \file
/// What a careful user must know of a surface, in sentences.
#pragma once

#include <string>
#include <vector>

#include "unsliver/domain.hpp"

namespace unsliver::domain {

/// Empty for a clean surface of positive volume without oddities. `turned` triangles were turned to agree
/// with their neighbours before the defects were counted.
std::vector<std::string> surface_notes(const SurfaceDefects& defects, std::size_t turned);

}  // namespace unsliver::domain
