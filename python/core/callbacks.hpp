/// \file
/// Python's callables as the library's callbacks, and Ctrl-C.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>

#include "unsliver/progress.hpp"

namespace unsliver::python {

namespace py = pybind11;

/// Lives as long as one run. Made and destroyed with the interpreter lock, called without it from any thread.
/// An exception in a callback, KeyboardInterrupt among them, ends the run as a cancellation does.
class Callbacks {
 public:
  /// Callables or None.
  Callbacks(py::object on_progress, py::object cancelled)
      : on_progress_(std::move(on_progress)), cancelled_(std::move(cancelled)) {}

  Control control();
  bool stopped() const { return stopped_; }
  /// Requires the interpreter lock. \throws what a callback has thrown.
  void rethrow();

 private:
  void show(const Progress& progress);
  bool poll();
  bool should_stop();  ///< with the interpreter lock
  void keep_exception();

  using Clock = std::chrono::steady_clock;
  static constexpr auto kInterval = std::chrono::milliseconds(20);

  py::object on_progress_, cancelled_;
  std::atomic<bool> stopped_ = false;
  std::mutex asking_;
  Clock::time_point next_question_{};  ///< guarded by asking_
  std::exception_ptr exception_;       ///< guarded by the interpreter lock
};

}  // namespace unsliver::python
