// SPDX-License-Identifier: MIT
// Ctrl-C during a long call: signal handlers of Python run only when they are asked for.
#pragma once

#include <chrono>
#include <exception>

#include "bind.hpp"

namespace pliant::python {

/// Asks Python about signals ten times a second at most. What a handler raised (KeyboardInterrupt)
/// is kept until the computation has ended in good order.
class InterruptWatch {
 public:
  /// True once a handler has raised. May be called without the GIL.
  bool operator()() {
    if (raised_) return true;
    const Clock::time_point now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return false;
    last_ = now;
    const nb::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() == 0) return false;
    raised_ = std::make_exception_ptr(nb::python_error());
    return true;
  }

  /// What a handler raised; null if nothing. Rethrow it with the GIL held.
  const std::exception_ptr& raised() const { return raised_; }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
  std::exception_ptr raised_;
};

}  // namespace pliant::python
