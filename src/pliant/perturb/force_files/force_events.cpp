// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_files/force_events.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "pliant/base/number.hpp"
#include "pliant/base/words.hpp"
#include "pliant/framework/joint_names.hpp"
#include "pliant/perturb/force_files/force_header_reader.hpp"
#include "pliant/perturb/force_files/force_line.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

/// Reads a file line by line.
class Parser {
 public:
  Parser(std::string_view file, const Framework& framework) : place_{file, 0}, names_(framework) {}

  std::vector<ForceEvent> parse(std::string_view text) {
    for (Lines lines(text); lines.next();) {
      place_.line = lines.number();
      const Words words = words_of(lines.line());
      if (!header_.take(words, lines.line(), place_)) take_event(words);
    }
    header_.end(place_.file);
    if (!forces_.empty()) fail(place_, "force: no step follows it");
    return std::move(events_);
  }

 private:
  void take_event(const Words& words) {
    const std::string_view word = words[0];
    if (word == "force") return forces_.push_back(force_of(words, names_, place_));
    if (word == "step") return take_step(words);
    if (word == "wander") return take_wander(words);
    if (!forces_.empty())
      fail(place_, "expected force, step or wander after a force, found " + quoted(word));
    if (word == "set") return take_set(words);
    if (word == "pin") return take_pins(words);
    if (word == "hold_back") return take_hold_back(words);
    if (word == "start") return take_start(words);
    for (const EditKind kind : {EditKind::cut, EditKind::bar, EditKind::restore})
      if (word == name(kind)) return take_edit(kind, words);
    fail(place_,
         "expected set, start, hold_back, pin, cut, bar, restore, force, step or wander, found " +
             quoted(word));
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
    const std::int64_t count = words.size() == 1 ? 1 : count_of(words);
    add(PullStep{std::exchange(forces_, {}), count});
  }

  void take_wander(const Words& words) {
    const std::int64_t count = count_of(words);
    add(WanderSteps{count, std::exchange(forces_, {})});
  }

  std::int64_t count_of(const Words& words) {
    const auto count = words.size() == 2 ? parse_integer(words[1]) : std::nullopt;
    if (!count || *count < 1 || *count > most_steps - steps_)
      fail(place_, std::string(words[0]) + ": expected a whole number of steps from 1");
    steps_ += *count;
    return *count;
  }

  void take_hold_back(const Words& words) {
    const auto longest = words.size() == 2 ? parse_real(words[1]) : std::nullopt;
    if (!longest || *longest <= 0.0) fail(place_, "hold_back: expected a number above 0");
    add(HoldBack{*longest});
  }

  void take_edit(EditKind kind, const Words& words) {
    const bool has_length = kind == EditKind::bar;
    if (words.size() != (has_length ? 4u : 3u))
      fail(place_, std::string(words[0]) + ": expected two joints" +
                       (has_length ? " and a length" : "") + ", found " +
                       std::to_string(words.size() - 1) + " fields");
    FrameworkEdit edit{kind, names_.find(words[1], place_), names_.find(words[2], place_)};
    if (has_length) edit.length = length_of(words[3]);
    add(edit);
  }

  double length_of(std::string_view word) const {
    const auto length = parse_real(word);
    if (!length || *length <= 0.0)
      fail(place_, "bar: expected a length above 0, found " + quoted(word));
    return *length;
  }

  void take_start(const Words& words) {
    if (words.size() != 1)
      fail(place_, "start: expected nothing after it, found " + quoted(words[1]));
    const auto is_setting = [](const ForceEvent& event) {
      return std::holds_alternative<SetOption>(event.what);
    };
    if (!std::ranges::all_of(events_, is_setting))
      fail(place_, "start: expected before all but set");
    add(StartWalk{});
  }

  /// Sums of counts stay numbers.
  static constexpr std::int64_t most_steps = std::int64_t{1} << 62;

  Place place_;
  JointNames names_;
  ForceHeaderReader header_;
  std::vector<JointForce> forces_;
  std::vector<ForceEvent> events_;
  std::int64_t steps_ = 0;
};

/// Writes events, each on lines of its own.
struct Writer {
  const JointNames& names;
  std::string& text;

  void add(const std::vector<JointForce>& forces) const {
    for (const JointForce& force : forces) text += force_line("force", force, names);
  }
  void operator()(const SetOption& set) const {
    text += "set " + set.name + " " + set.value + "\n";
  }
  void operator()(const PinJoints& pins) const {
    text += "pin";
    for (Joint joint : pins.joints) text += " " + names.word_for(joint, "force file");
    text += "\n";
  }
  void operator()(const PullStep& pull) const {
    add(pull.forces);
    text += pull.count == 1 ? "step\n" : "step " + std::to_string(pull.count) + "\n";
  }
  void operator()(const WanderSteps& wander) const {
    add(wander.forces);
    text += "wander " + std::to_string(wander.count) + "\n";
  }
  void operator()(const HoldBack& hold) const {
    text += "hold_back " + shortest_text(hold.longest_step) + "\n";
  }
  void operator()(const StartWalk&) const { text += "start\n"; }
  void operator()(const FrameworkEdit& edit) const {
    text += std::string(name(edit.kind));
    for (const Joint joint : {edit.a, edit.b}) text += " " + names.word_for(joint, "force file");
    if (edit.kind == EditKind::bar) text += " " + shortest_text(edit.length);
    text += "\n";
  }
};

std::int64_t steps_in(const ForceEvent& event) {
  if (const auto* pull = std::get_if<PullStep>(&event.what)) return pull->count;
  if (const auto* wander = std::get_if<WanderSteps>(&event.what)) return wander->count;
  return 0;
}

/// Bit by bit: -0 is not 0.
bool are_same(std::span<const JointForce> a, std::span<const JointForce> b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return std::ranges::equal(a, b, [&](const JointForce& one, const JointForce& other) {
    const Vec3 f = one.force;
    const Vec3 g = other.force;
    return one.joint == other.joint && bits(f.x) == bits(g.x) && bits(f.y) == bits(g.y) &&
           bits(f.z) == bits(g.z);
  });
}

template <class Steps>
void add_step(std::vector<ForceEvent>& events, std::span<const JointForce> forces) {
  auto* last = events.empty() ? nullptr : std::get_if<Steps>(&events.back().what);
  if (last != nullptr && are_same(last->forces, forces)) {
    ++last->count;
    return;
  }
  Steps steps;
  steps.forces.assign(forces.begin(), forces.end());
  events.push_back({std::move(steps)});
}

}  // namespace

std::vector<ForceEvent> parse_force_events(std::string_view text, std::string_view file_name,
                                           const Framework& framework) {
  return Parser(file_name, framework).parse(text);
}

std::string write_force_events(std::span<const ForceEvent> events, const Framework& framework,
                               const ForceHeader& header) {
  const JointNames names(framework);
  std::string text = write_force_header(header);
  for (const ForceEvent& event : events) std::visit(Writer{names, text}, event.what);
  return text;
}

void add_pull(std::vector<ForceEvent>& events, std::span<const JointForce> forces) {
  add_step<PullStep>(events, forces);
}

void add_wander(std::vector<ForceEvent>& events, std::span<const JointForce> forces) {
  add_step<WanderSteps>(events, forces);
}

std::int64_t steps_of(std::span<const ForceEvent> events) {
  std::int64_t steps = 0;
  for (const ForceEvent& event : events) steps += steps_in(event);
  return steps;
}

std::string edits_text(std::span<const ForceEvent> events, const Framework& framework) {
  std::string text;
  std::int64_t steps = 0;
  for (const ForceEvent& event : events) {
    steps += steps_in(event);
    const auto* edit = std::get_if<FrameworkEdit>(&event.what);
    if (edit == nullptr) continue;
    if (!text.empty()) text += "; ";
    text += "after step " + std::to_string(steps) + ": " + text_of(*edit, framework);
  }
  return text;
}

}  // namespace pliant
