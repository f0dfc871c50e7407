/// \file
/// Progress out and cancel in, at a bearable rate.
#pragma once

#include <chrono>
#include <cstdint>

#include "unsliver/progress.hpp"

namespace unsliver::verifier {

/// Thrown by Pulse::beat when the caller asks to stop; never leaves the module.
struct Cancelled {};

class Pulse {
 public:
  /// `expected`: the work of the whole run in units of beat(). `vertices`, `tets`: passed on as they are.
  Pulse(const Control& control, std::uint64_t expected, std::uint64_t vertices, std::uint64_t tets)
      : control_(control), progress_{"verify", 0, expected, vertices, tets} {}

  /// One unit of work done. \throws Cancelled
  void beat() {
    if ((++progress_.done & kMask) == 0) look();
  }
  /// Many units of work done. \throws Cancelled
  void beats(std::uint64_t n) {
    progress_.done += n;
    look();
  }

 private:
  static constexpr std::uint64_t kMask = 2047;  ///< of cheap units: well below a millisecond
  using Clock = std::chrono::steady_clock;

  void look() {
    if (control_.cancelled && control_.cancelled()) throw Cancelled{};
    if (!control_.on_progress) return;
    const auto now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(200)) return;
    last_ = now;
    control_.on_progress(progress_);
  }

  const Control& control_;
  Progress progress_;
  Clock::time_point last_ = Clock::now();
};

}  // namespace unsliver::verifier
