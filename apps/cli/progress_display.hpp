/// \file
/// One line on a terminal that follows a long run: phase, size, rate, remaining time.
#pragma once

#include <chrono>
#include <string>

#include "unsliver/progress.hpp"

namespace unsliver::cli {

/// Silent unless `enabled`. The line is wiped when the display ends.
class ProgressDisplay {
 public:
  explicit ProgressDisplay(bool enabled) : enabled_(enabled) {}
  ~ProgressDisplay() { clear(); }
  ProgressDisplay(const ProgressDisplay&) = delete;
  ProgressDisplay& operator=(const ProgressDisplay&) = delete;

  void show(const Progress& progress);
  /// For phases that do not report: "reading spot.obj ...".
  void show(const std::string& text);
  void clear();

  /// Progress to this display, cancellation from Ctrl-C.
  Control control();

 private:
  using Clock = std::chrono::steady_clock;
  void draw(const std::string& line);

  bool enabled_;
  bool drawn_ = false;
  std::string phase_;
  Clock::time_point phase_start_{};
  std::uint64_t done_at_start_ = 0;
};

}  // namespace unsliver::cli
