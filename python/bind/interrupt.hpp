// SPDX-License-Identifier: MIT
// Long calls: Ctrl-C, whose handler in Python runs only when asked for, and progress bars.
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>

#include "bind.hpp"

namespace pliant::python {

/// Checks for Python's signals at most ten times a second, if no other interval is given. An
/// exception of a handler (KeyboardInterrupt) is kept until the computation has ended in good
/// order.
class InterruptWatch {
 public:
  InterruptWatch() = default;

  /// Shows a bar in notebooks and on terminals, for `total` items called `what`, and looks as often
  /// as pliant.base.progress says. Made and destroyed with the GIL held.
  InterruptWatch(const char* what, std::int64_t total) {
    const nb::module_ progress = nb::module_::import_("pliant.base.progress");
    interval_ = Seconds(nb::cast<double>(progress.attr("INTERVAL")));
    bar_ = progress.attr("begin")(what, total);
  }

  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
  InterruptWatch(InterruptWatch&&) = default;
  InterruptWatch& operator=(InterruptWatch&&) = default;

  ~InterruptWatch() {
    if (!bar_.is_valid() || bar_.is_none()) return;
    try {
      bar_.attr("close")();
    } catch (nb::python_error& error) {
      error.discard_as_unraisable("closing a progress bar");
    }
  }

  /// True once a handler has raised. May be called without the GIL.
  bool operator()(std::int64_t done = 0) {
    if (raised_) return true;
    const Clock::time_point now = Clock::now();
    if (now - last_ < interval_) return false;
    last_ = now;
    const nb::gil_scoped_acquire gil;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (bar_.is_valid() && !bar_.is_none()) bar_.attr("show")(done);
    } catch (const nb::python_error&) {
      raised_ = std::current_exception();
    }
    return raised_ != nullptr;
  }

  /// The exception of a handler; null if there was none. Rethrow it with the GIL held.
  const std::exception_ptr& raised() const { return raised_; }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;
  Seconds interval_{0.1};
  Clock::time_point last_ = Clock::now();
  std::exception_ptr raised_;
  nb::object bar_;
};

}  // namespace pliant::python
