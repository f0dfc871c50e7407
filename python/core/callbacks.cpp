#include "callbacks.hpp"

namespace unsliver::python {

Control Callbacks::control() {
  Control control;
  if (!on_progress_.is_none()) control.on_progress = [this](const Progress& progress) { show(progress); };
  control.cancelled = [this] { return poll(); };
  return control;
}

void Callbacks::rethrow() {
  if (exception_) std::rethrow_exception(std::exchange(exception_, nullptr));
}

void Callbacks::keep_exception() {
  exception_ = std::current_exception();
  stopped_ = true;
}

void Callbacks::show(const Progress& progress) {
  const py::gil_scoped_acquire lock;
  try {
    if (!exception_) on_progress_(progress);
  } catch (...) {
    keep_exception();
  }
}

/// Asked every few microseconds, and Python is slow: most of the time the answer is the last one. A thread
/// that meets another one asking does not wait.
bool Callbacks::poll() {
  const std::unique_lock<std::mutex> alone(asking_, std::try_to_lock);
  if (stopped_ || !alone) return stopped_;
  const auto now = Clock::now();
  if (now < next_question_) return false;
  {
    const py::gil_scoped_acquire lock;
    try {
      stopped_ = should_stop();
    } catch (...) {
      keep_exception();
    }
  }
  next_question_ = Clock::now() + kInterval;
  return stopped_;
}

bool Callbacks::should_stop() {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return !cancelled_.is_none() && py::bool_(cancelled_());
}

}  // namespace unsliver::python
