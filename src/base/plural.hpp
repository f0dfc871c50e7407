/// \file
/// Counts in sentences.
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace unsliver {

/// "1 vertex", "2 vertices".
inline std::string plural(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace unsliver
