// SPDX-License-Identifier: MIT
#include "messages.hpp"

#include <fmt/format.h>

#include "pliant/base/printable.hpp"
#include "pliant/base/system/terminal.hpp"

namespace pliant::app {

void Messages::say(Severity severity, std::string_view text) const {
  const char* word = severity == Severity::warning ? "warning" : "note";
  if (!quiet_) fmt::print(stderr, "{}: {}\n", word, printable(text));
}

Log Messages::log() {
  return {[this](Severity severity, std::string_view text) {
    (severity == Severity::warning ? warnings_ : notes_).emplace_back(text);
    say(severity, text);
  }};
}

Log Messages::log_of_model(const std::string& file, bool verbose) {
  is_brief_ = !verbose;
  if (verbose) return log();
  return {[this, file](Severity severity, std::string_view text) {
    (severity == Severity::warning ? warnings_ : notes_).emplace_back(text);
    const bool is_on_line = severity == Severity::warning && text.starts_with(file + ":");
    if (severity == Severity::detail || (is_on_line && ++on_lines_ > 1)) return;
    say(severity, text);
  }};
}

void Messages::end_model(const std::vector<std::string>& left_out) {
  if (!is_brief_) return;
  if (on_lines_ > 1)
    say(Severity::note,
        fmt::format("{} more warnings on lines of the file; --verbose shows them", on_lines_ - 1));
  if (!left_out.empty())
    say(Severity::note, fmt::format("left out: {}", fmt::join(left_out, "; ")));
}

void add_verbose(CommandLine& line, bool& verbose) {
  line.add_flag("--verbose", verbose, "print all that was done and found on the way");
}

ProgressBar::ProgressBar(std::int64_t total, std::string unit, bool quiet)
    : total_(total), unit_(std::move(unit)), enabled_(!quiet && is_stderr_a_terminal()) {}

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
