// SPDX-License-Identifier: MIT
#include "messages.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "pliant/base/printable.hpp"

namespace pliant::app {

Log Messages::log() {
  return {[this](Severity severity, std::string_view text) {
    const bool is_warning = severity == Severity::warning;
    (is_warning ? warnings_ : notes_).emplace_back(text);
    if (!quiet_) fmt::print(stderr, "{}: {}\n", is_warning ? "warning" : "note", printable(text));
  }};
}

ProgressBar::ProgressBar(std::int64_t total, std::string unit, bool quiet)
    : total_(total), unit_(std::move(unit)), enabled_(!quiet && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::show(std::int64_t done) {
  if (!enabled_) return;
  const Clock::time_point now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - start_).count();
  if (seconds < 1.0 || now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  draw(done, seconds);
}

void ProgressBar::draw(std::int64_t done, double seconds) {
  constexpr int width = 30;
  const double share = total_ > 0 ? double(done) / double(total_) : 1.0;
  const int filled = static_cast<int>(share * width);
  const double left = share > 0.0 ? seconds * (1.0 - share) / share : 0.0;
  fmt::print(stderr, "\r[{:#<{}}{:-<{}}] {} / {} {}, {:.0f} s left\x1b[K", "", filled, "",
             width - filled, done, total_, unit_, left);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace pliant::app
