// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_files/force_file.hpp"

#include <algorithm>
#include <utility>

#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/words.hpp"
#include "pliant/framework/joint_names.hpp"
#include "pliant/perturb/force_files/force_header_reader.hpp"
#include "pliant/perturb/force_files/force_line.hpp"
#include "pliant/text/file_text.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

/// Reads a force file line by line.
class Parser {
 public:
  Parser(std::string_view file, const Framework& framework) : place_{file, 0}, names_(framework) {}

  ForceFile parse(std::string_view text) {
    if (has_force_events(text))
      fail({place_.file},
           "holds what a person did, event by event; expected pushes alone, one a step");
    for (Lines lines(text); lines.next();) {
      place_.line = lines.number();
      const Words words = words_of(lines.line());
      if (!header_.take(words, lines.line(), place_)) take(words);
    }
    header_.end(place_.file);
    found_.header = std::move(header_.header);
    return std::move(found_);
  }

 private:
  void take(const Words& words) {
    if (words[0] == "push") return take_push(words);
    if (words[0] != "set")
      fail(place_,
           "expected structure, joints, bars, input, set or push, found " + quoted(words[0]));
    if (words.size() != 3)
      fail(place_, "set: expected a name and a value, found " + std::to_string(words.size() - 1) +
                       " fields");
    if (!found_.pushes.empty()) fail(place_, "set: expected before the first push");
    take_setting({words[1], words[2]});
  }

  void take_setting(const Words& words) {
    if (words[0] == "timestep") {
      set(found_.timestep, words, positive(words));
    } else if (words[0] == "tolerance") {
      set(found_.tolerance, words, positive(words));
    } else if (words[0] == "tolerance_length") {
      set(found_.tolerance_length, words, positive(words));
    } else if (words[0] == "max_sweeps") {
      take_max_sweeps(words);
    } else {
      take_other(words);
    }
  }

  void take_other(const Words& words) {
    const std::string name(words[0]);
    if (std::ranges::count(found_.settings, name, &ForceSetting::name) > 0)
      fail(place_, name + ": is given twice");
    found_.settings.push_back({name, std::string(words[1]), place_.line});
  }

  template <class Value>
  void set(std::optional<Value>& setting, const Words& words, Value value) {
    if (setting) fail(place_, std::string(words[0]) + ": is given twice");
    setting = value;
  }

  double positive(const Words& words) {
    const auto value = parse_real(words[1]);
    if (!value || *value <= 0.0)
      fail(place_,
           std::string(words[0]) + ": expected a number above 0, found " + quoted(words[1]));
    return *value;
  }

  void take_max_sweeps(const Words& words) {
    const auto value = parse_integer(words[1]);
    if (!value || *value < 1)
      fail(place_, "max_sweeps: expected a whole number from 1, found " + quoted(words[1]));
    set(found_.max_sweeps, words, *value);
  }

  void take_push(const Words& words) { found_.pushes.push_back(force_of(words, names_, place_)); }

  Place place_;
  JointNames names_;
  ForceHeaderReader header_;
  ForceFile found_;
};

std::vector<ForceEvent> events_of(const ForceFile& forces) {
  std::vector<ForceEvent> events = settings_of(forces);
  const std::span<const JointForce> all(forces.pushes);
  std::size_t at = 0;
  for (const std::int64_t count : forces.counts) {
    add_pull(events, all.subspan(at, static_cast<std::size_t>(count)));
    at += static_cast<std::size_t>(count);
  }
  return events;
}

}  // namespace

std::vector<ForceEvent> settings_of(const ForceFile& forces) {
  std::vector<ForceEvent> settings;
  const auto add = [&](const char* name, const std::optional<double>& value) {
    if (value) settings.push_back({SetOption{name, shortest_text(*value)}});
  };
  add("timestep", forces.timestep);
  add("tolerance", forces.tolerance);
  add("tolerance_length", forces.tolerance_length);
  if (forces.max_sweeps)
    settings.push_back({SetOption{"max_sweeps", std::to_string(*forces.max_sweeps)}});
  for (const ForceSetting& one : forces.settings)
    settings.push_back({SetOption{one.name, one.value}, one.line});
  return settings;
}

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
  ForceFile file = parse_force_file(without_byte_order_mark(bytes), path_text(path), framework);
  check_fit(file.header, framework, path_text(path));
  return file;
}

std::string write_force_file(const ForceFile& forces, const Framework& framework) {
  if (!forces.counts.empty())
    return write_force_events(events_of(forces), framework, forces.header);
  const JointNames names(framework);
  std::string text = write_force_header(forces.header);
  for (const ForceEvent& event : settings_of(forces)) {
    const auto& set = std::get<SetOption>(event.what);
    text += "set " + set.name + " " + set.value + "\n";
  }
  for (const JointForce& push : forces.pushes) text += force_line("push", push, names);
  return text;
}

}  // namespace pliant
