// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_events.hpp"

#include <cmath>
#include <utility>

#include "pliant/base/number.hpp"
#include "pliant/base/words.hpp"
#include "pliant/framework/joint_names.hpp"
#include "pliant/perturb/force_line.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

constexpr std::string_view heading = "pliant-forces 2";

bool is_heading(const Words& words) {
  return words.size() == 2 && words[0] == "pliant-forces" && words[1] == "2";
}

/// Reads a file line by line.
class Parser {
 public:
  Parser(std::string_view file, const Framework& framework) : place_{file, 0}, names_(framework) {}

  std::vector<ForceEvent> parse(std::string_view text) {
    for (Lines lines(text); lines.next();) {
      place_.line = lines.number();
      take(words_of(lines.line()), lines.line());
    }
    if (!headed_)
      fail({place_.file}, "expected the line " + quoted(heading) + " first, found no text");
    if (!forces_.empty()) fail(place_, "force: no step follows it");
    return std::move(events_);
  }

 private:
  void take(const Words& words, std::string_view line) {
    if (words.empty()) return;
    if (!headed_) {
      if (!is_heading(words))
        fail(place_, "expected " + quoted(heading) + ", found " + quoted(trimmed(line)));
      headed_ = true;
    } else {
      take_event(words);
    }
  }

  void take_event(const Words& words) {
    const std::string_view word = words[0];
    if (word == "force") return forces_.push_back(force_of(words, names_, place_));
    if (!forces_.empty() && word != "step")
      fail(place_, "expected force or step after a force, found " + quoted(word));
    if (word == "set") return take_set(words);
    if (word == "pin") return take_pins(words);
    if (word == "step") return take_step(words);
    if (word == "wander") return take_wander(words);
    fail(place_, "expected set, pin, force, step or wander, found " + quoted(word));
  }

  template <class What>
  void add(What what) {
    events_.push_back({std::move(what), place_.line});
  }

  void take_set(const Words& words) {
    if (words.size() != 3)
      fail(place_, "set: expected a name and a value, found " + std::to_string(words.size() - 1) +
                       " fields");
    add(SetOption{std::string(words[1]), std::string(words[2])});
  }

  void take_pins(const Words& words) {
    PinJoints pins;
    for (std::size_t k = 1; k < words.size(); ++k)
      pins.joints.push_back(names_.find(words[k], place_));
    add(std::move(pins));
  }

  void take_step(const Words& words) {
    if (words.size() != 1)
      fail(place_, "step: expected nothing after it, found " + quoted(words[1]));
    add(PullStep{std::exchange(forces_, {})});
  }

  void take_wander(const Words& words) {
    const auto count = words.size() == 2 ? parse_integer(words[1]) : std::nullopt;
    if (!count || *count < 1) fail(place_, "wander: expected a whole number of steps from 1");
    add(WanderSteps{*count});
  }

  Place place_;
  JointNames names_;
  bool headed_ = false;
  std::vector<JointForce> forces_;
  std::vector<ForceEvent> events_;
};

/// Writes events, each on lines of its own.
struct Writer {
  const JointNames& names;
  std::string& text;

  void operator()(const SetOption& set) const {
    text += "set " + set.name + " " + set.value + "\n";
  }
  void operator()(const PinJoints& pins) const {
    text += "pin";
    for (Joint joint : pins.joints) text += " " + names.word_for(joint, "force file");
    text += "\n";
  }
  void operator()(const PullStep& pull) const {
    for (const JointForce& force : pull.forces) text += force_line("force", force, names);
    text += "step\n";
  }
  void operator()(const WanderSteps& wander) const {
    text += "wander " + std::to_string(wander.count) + "\n";
  }
};

}  // namespace

bool has_force_events(std::string_view text) {
  for (Lines lines(text); lines.next();)
    if (const Words words = words_of(lines.line()); !words.empty()) return is_heading(words);
  return false;
}

std::vector<ForceEvent> parse_force_events(std::string_view text, std::string_view file_name,
                                           const Framework& framework) {
  return Parser(file_name, framework).parse(text);
}

std::string write_force_events(std::span<const ForceEvent> events, const Framework& framework) {
  const JointNames names(framework);
  std::string text = std::string(heading) + "\n";
  for (const ForceEvent& event : events) std::visit(Writer{names, text}, event.what);
  return text;
}

std::int64_t steps_of(std::span<const ForceEvent> events) {
  std::int64_t steps = 0;
  for (const ForceEvent& event : events) {
    if (std::holds_alternative<PullStep>(event.what)) ++steps;
    if (const auto* wander = std::get_if<WanderSteps>(&event.what)) steps += wander->count;
  }
  return steps;
}

}  // namespace pliant
