// SPDX-License-Identifier: MIT
// A force file that the session repeats, step by step.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "session.hpp"

namespace pliant::play {

class Replay {
 public:
  /// Reads the file. Throws InputError naming file and line, also where it was made for another
  /// framework or structure.
  Replay(std::string_view text, std::string name, const Document& document);

  const std::vector<ForceEvent>& events() const { return events_; }
  std::int64_t steps() const { return steps_of(events_); }
  /// Steps made so far, and the event that comes next.
  std::int64_t done() const { return done_; }
  std::size_t next() const { return next_; }
  bool is_over() const { return next_ == events_.size(); }

  /// Begins at the start of `session`, which must have made no step. Throws OptionError.
  void begin(Session& session);
  /// Goes on to the next step. Returns what it did; none: there is none left. Throws InputError
  /// naming the line of an event that cannot be.
  std::optional<StepReport> step(Session& session);

 private:
  std::optional<StepReport> apply(Session& session, const ForceEvent& event) const;

  std::string name_;
  std::vector<ForceEvent> events_;
  std::size_t next_ = 0;       ///< number of the event
  std::int64_t in_event_ = 0;  ///< steps of it that were made
  std::int64_t done_ = 0;
};

}  // namespace pliant::play
