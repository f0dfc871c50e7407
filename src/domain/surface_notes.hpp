/// \file
/// What a careful user must know of a surface, in sentences.
#pragma once

#include <string>
#include <vector>

#include "unsliver/domain.hpp"

namespace unsliver::domain {

/// Empty for a clean surface of positive volume without oddities.
std::vector<std::string> surface_notes(const SurfaceDefects& defects);

}  // namespace unsliver::domain
