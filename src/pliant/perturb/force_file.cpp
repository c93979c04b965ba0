// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_file.hpp"

#include <algorithm>
#include <utility>

#include "pliant/base/number.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/words.hpp"
#include "pliant/framework/joint_names.hpp"
#include "pliant/perturb/force_events.hpp"
#include "pliant/perturb/force_line.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {
namespace {

constexpr std::string_view heading = "pliant-forces 1";

/// Reads a force file line by line.
class Parser {
 public:
  Parser(std::string_view file, const Framework& framework) : place_{file, 0}, names_(framework) {}

  ForceFile parse(std::string_view text) {
    for (std::size_t i = 0; i <= text.size();) {
      const std::size_t end = std::min(text.find('\n', i), text.size());
      ++place_.line;
      take(words_of(text.substr(i, end - i)), text.substr(i, end - i));
      i = end + 1;
    }
    place_.line = 0;
    if (!headed_) fail(place_, "expected the line " + quoted(heading) + " first, found no text");
    return std::move(found_);
  }

 private:
  void take(const Words& words, std::string_view line) {
    if (words.empty()) return;
    if (!headed_) {
      if (words.size() != 2 || words[0] != "pliant-forces" || words[1] != "1")
        fail(place_, "expected " + quoted(heading) + ", found " + quoted(trimmed(line)));
      headed_ = true;
    } else if (words[0] == "push") {
      take_push(words);
    } else if (words[0] == "timestep") {
      set(found_.timestep, words, positive(words));
    } else if (words[0] == "tolerance") {
      set(found_.tolerance, words, positive(words));
    } else if (words[0] == "tolerance_length") {
      set(found_.tolerance_length, words, positive(words));
    } else if (words[0] == "max_sweeps") {
      take_max_sweeps(words);
    } else {
      fail(place_, "expected timestep, tolerance, tolerance_length, max_sweeps or push, found " +
                       quoted(words[0]));
    }
  }

  void expect_words(const Words& words, std::size_t count, std::string_view what) {
    if (words.size() != count)
      fail(place_, std::string(words[0]) + ": expected " + std::string(what) + ", found " +
                       std::to_string(words.size() - 1) + " fields");
  }

  template <class Value>
  void set(std::optional<Value>& setting, const Words& words, Value value) {
    if (setting) fail(place_, std::string(words[0]) + ": is given twice");
    setting = value;
  }

  double positive(const Words& words) {
    expect_words(words, 2, "one number");
    const auto value = parse_real(words[1]);
    if (!value || *value <= 0.0)
      fail(place_,
           std::string(words[0]) + ": expected a number above 0, found " + quoted(words[1]));
    return *value;
  }

  void take_max_sweeps(const Words& words) {
    expect_words(words, 2, "one whole number");
    const auto value = parse_integer(words[1]);
    if (!value || *value < 1)
      fail(place_, "max_sweeps: expected a whole number from 1, found " + quoted(words[1]));
    set(found_.max_sweeps, words, *value);
  }

  void take_push(const Words& words) { found_.pushes.push_back(force_of(words, names_, place_)); }

  Place place_;
  JointNames names_;
  bool headed_ = false;
  ForceFile found_;
};

/// Those that every file has, as name and text.
std::vector<SetOption> settings_of(const ForceFile& forces) {
  std::vector<SetOption> settings;
  const auto add = [&](const char* name, const std::optional<double>& value) {
    if (value) settings.push_back({name, shortest_text(*value)});
  };
  add("timestep", forces.timestep);
  add("tolerance", forces.tolerance);
  add("tolerance_length", forces.tolerance_length);
  if (forces.max_sweeps) settings.push_back({"max_sweeps", std::to_string(*forces.max_sweeps)});
  return settings;
}

std::vector<ForceEvent> events_of(const ForceFile& forces) {
  std::vector<ForceEvent> events;
  for (SetOption& setting : settings_of(forces)) events.push_back({std::move(setting)});
  for (const auto& [name, value] : forces.settings) events.push_back({SetOption{name, value}});
  auto next = forces.pushes.begin();
  for (const std::int64_t count : forces.counts) {
    if (count < 0) {
      events.push_back({WanderSteps{-count}});
      continue;
    }
    events.push_back({PullStep{{next, next + count}}});
    next += count;
  }
  return events;
}

}  // namespace

void ForceFile::set(const PerturbOptions& options, Tolerance within, std::int64_t most_sweeps) {
  timestep = options.timestep;
  tolerance = within.length == 0.0 ? std::optional(within.relative) : std::nullopt;
  tolerance_length = within.length != 0.0 ? std::optional(within.length) : std::nullopt;
  max_sweeps = most_sweeps;
}

ForceFile make_force_file(const Framework& framework, const PerturbOptions& options,
                          Tolerance tolerance, std::int64_t max_sweeps, const RandomKey& key,
                          std::int64_t count) {
  ForceFile file;
  file.set(options, tolerance, max_sweeps);
  file.pushes = random_pushes(framework, options, key, count);
  return file;
}

ForceFile parse_force_file(std::string_view text, std::string_view file_name,
                           const Framework& framework) {
  return Parser(file_name, framework).parse(text);
}

ForceFile read_force_file(const std::filesystem::path& path, const Framework& framework) {
  const std::string bytes = read_bytes(path);
  return parse_force_file(without_byte_order_mark(bytes), path.string(), framework);
}

std::string write_force_file(const ForceFile& forces, const Framework& framework) {
  if (!forces.counts.empty()) return write_force_events(events_of(forces), framework);
  const JointNames names(framework);
  std::string text = std::string(heading) + "\n";
  for (const auto& [name, value] : settings_of(forces)) text += name + " " + value + "\n";
  for (const JointForce& push : forces.pushes) text += force_line("push", push, names);
  return text;
}

}  // namespace pliant
