// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "pliant/base/number.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/words.hpp"
#include "pliant/framework/joint_names.hpp"

namespace pliant {
namespace {

constexpr std::string_view heading = "pliant-forces 1";
/// The square of a larger force overflows on its way to a length.
constexpr double largest_force = 1e100;

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

  void take_push(const Words& words) {
    expect_words(words, 5, "a joint and a force (x, y, z)");
    const Joint joint = names_.find(words[1], place_);
    found_.pushes.push_back(
        {joint, {component(words, 2), component(words, 3), component(words, 4)}});
  }

  double component(const Words& words, std::size_t k) {
    const auto value = parse_real(words[k]);
    if (!value || std::abs(*value) > largest_force)
      fail(place_, std::string("force ") + "xyz"[k - 2] +
                       ": expected a finite number up to 1e100, found " + quoted(words[k]));
    return *value;
  }

  Place place_;
  JointNames names_;
  bool headed_ = false;
  ForceFile found_;
};

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
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw FileError(printable_name(path.string()) +
                    ": cannot be read: " + (error ? error.message() : "not a regular file"));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw FileError(printable_name(path.string()) + ": cannot be opened for reading");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse_force_file(text, path.string(), framework);
}

std::string write_force_file(const ForceFile& forces, const Framework& framework) {
  const JointNames names(framework);
  std::string text = std::string(heading) + "\n";
  const auto setting = [&](const char* name, const std::optional<double>& value) {
    if (value) text += std::string(name) + " " + shortest_text(*value) + "\n";
  };
  setting("timestep", forces.timestep);
  setting("tolerance", forces.tolerance);
  setting("tolerance_length", forces.tolerance_length);
  if (forces.max_sweeps) text += "max_sweeps " + std::to_string(*forces.max_sweeps) + "\n";
  for (const JointForce& push : forces.pushes) {
    text += "push " + names.word_for(push.joint, "force file") + " " + shortest_text(push.force.x) +
            " " + shortest_text(push.force.y) + " " + shortest_text(push.force.z) + "\n";
  }
  return text;
}

}  // namespace pliant
