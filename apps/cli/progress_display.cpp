#include "progress_display.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "interrupts.hpp"
#include "text.hpp"

namespace unsliver::cli {
namespace {

/// Before this the rate says little.
constexpr double kSettleSeconds = 0.5;

std::string remaining(const Progress& progress, double rate) {
  if (progress.expected <= progress.done || !(rate > 0)) return {};
  const double seconds = static_cast<double>(progress.expected - progress.done) / rate;
  const double percent = 100.0 * static_cast<double>(progress.done) / static_cast<double>(progress.expected);
  return fmt::format("  {:.0f} %, about {} left", percent, human_seconds(seconds));
}

}  // namespace

void ProgressDisplay::show(const Progress& progress) {
  if (!enabled_) return;
  if (progress.phase != phase_) {
    phase_ = progress.phase;
    phase_start_ = Clock::now();
    done_at_start_ = progress.done;
  }
  std::string line = phase_;
  if (progress.tets > 0)
    line += fmt::format("  {} tetrahedra", human_count(static_cast<double>(progress.tets)));
  const double seconds = std::chrono::duration<double>(Clock::now() - phase_start_).count();
  if (seconds > kSettleSeconds && progress.done > done_at_start_) {
    const double rate = static_cast<double>(progress.done - done_at_start_) / seconds;
    line += fmt::format("  {}/s", human_count(rate)) + remaining(progress, rate);
  }
  draw(line);
}

void ProgressDisplay::show(const std::string& text) {
  if (enabled_) draw(text);
}

void ProgressDisplay::clear() {
  if (drawn_) std::fputs("\r\x1b[K", stderr);
  drawn_ = false;
}

Control ProgressDisplay::control() {
  return {[this](const Progress& progress) { show(progress); }, [] { return interrupts::requested(); }};
}

void ProgressDisplay::draw(const std::string& line) {
  std::fprintf(stderr, "\r%s\x1b[K", line.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace unsliver::cli
