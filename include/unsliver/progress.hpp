/// \file
/// How a long run talks to its caller: progress out, cancel in.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

namespace unsliver {

/// A snapshot of a running phase. Sent a few times a second, from the thread that called the library.
struct Progress {
  std::string_view phase;      ///< "size", "quality", "extract", "verify", "write", ...
  std::uint64_t done = 0;      ///< units of work done (insertions, tetrahedra, ...)
  std::uint64_t expected = 0;  ///< estimate of the total, 0 when unknown; may be revised
  std::uint64_t vertices = 0;  ///< size of the mesh so far
  std::uint64_t tets = 0;
};

/// Callbacks of a long run. Both may be empty. Neither may throw.
struct Control {
  std::function<void(const Progress&)> on_progress;
  /// Polled often (at least every few milliseconds of work); true asks the run to stop soon.
  std::function<bool()> cancelled;
};

}  // namespace unsliver
