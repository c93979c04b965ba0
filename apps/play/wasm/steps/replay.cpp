// SPDX-License-Identifier: MIT
#include "steps/replay.hpp"

#include <algorithm>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/perturb/force_files/force_file.hpp"

namespace pliant::play {
namespace {

/// Pushes alone, one a step: the command makes the start whole under the settings of the file.
std::vector<ForceEvent> events_of(const ForceFile& file) {
  std::vector<ForceEvent> events = settings_of(file);
  for (const ForceSetting& one : file.settings)
    events.push_back({SetOption{one.name, one.value}, one.line});
  events.push_back({StartWalk{}});
  for (const JointForce& push : file.pushes) add_pull(events, {&push, 1});
  return events;
}

void check_structure(const ForceHeader& header, const Document& document, const std::string& name) {
  check_fit(header, document.framework, name);
  if (!header.structure || !document.fingerprint || *header.structure == *document.fingerprint)
    return;
  throw InputError(name + ": was made for another structure (fingerprint " +
                   fingerprint_text(*header.structure) + ", not " +
                   fingerprint_text(*document.fingerprint) + ")");
}

std::int64_t count_of(const ForceEvent& event) {
  if (const auto* pull = std::get_if<PullStep>(&event.what)) return pull->count;
  if (const auto* wander = std::get_if<WanderSteps>(&event.what)) return wander->count;
  return 1;
}

}  // namespace

Replay::Replay(std::string_view text, std::string name, const Document& document)
    : name_(std::move(name)) {
  check_structure(read_force_header(text, name_), document, name_);
  events_ = has_force_events(text) ? parse_force_events(text, name_, document.framework)
                                   : events_of(parse_force_file(text, name_, document.framework));
}

void Replay::begin(Session& session) {
  if (session.state().step != 0)
    throw OptionError("replay: expected a session at its start, which has made no step");
  next_ = 0;
  in_event_ = done_ = 0;
  session.begin_events({});
}

std::optional<StepReport> Replay::apply(Session& session, const ForceEvent& event) const {
  try {
    return session.apply(event);
  } catch (const OptionError& error) {
    fail({name_, event.line}, error.what());
  }
}

std::optional<StepReport> Replay::step(Session& session) {
  while (next_ < events_.size()) {
    const ForceEvent& event = events_[next_];
    std::optional<StepReport> made = apply(session, event);
    if (++in_event_ >= count_of(event)) {
      ++next_;
      in_event_ = 0;
    }
    if (!made) continue;
    ++done_;
    return made;
  }
  session.settle();
  return std::nullopt;
}

}  // namespace pliant::play
