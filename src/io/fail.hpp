/// \file
/// Raises an Error from a format string.
#pragma once

#include <fmt/format.h>

#include <utility>

#include "unsliver/error.hpp"

namespace unsliver::io {

template <class... Args>
[[noreturn]] void fail(ErrorCode code, fmt::format_string<Args...> text, Args&&... args) {
  throw Error(code, fmt::format(text, std::forward<Args>(args)...));
}

}  // namespace unsliver::io
