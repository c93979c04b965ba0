// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <unordered_map>

#include "pliant/base/number.hpp"

namespace pliant {
namespace {

constexpr std::string_view heading = "pliant-forces 1";
/// The square of a larger force overflows on its way to a length.
constexpr double largest_force = 1e100;

using Words = std::vector<std::string_view>;

Words split(std::string_view line) {
  Words words;
  line = line.substr(0, line.find('#'));
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t start = line.find_first_not_of(" \t\r", i);
    if (start == std::string_view::npos) break;
    i = std::min(line.find_first_of(" \t\r", start), line.size());
    words.push_back(line.substr(start, i - start));
  }
  return words;
}

std::string shortest(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// Names that belong to exactly one joint.
class JointNames {
 public:
  explicit JointNames(const Framework& framework) : framework_(framework) {
    if (!framework.atoms()) return;
    const auto& names = framework.atoms()->names;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto [at, is_new] = joints_.emplace(names[i], static_cast<Joint>(i));
      if (!is_new) ++repeats_[names[i]];
    }
  }

  Joint find(std::string_view word, const Place& place) const {
    if (repeats_.contains(word))
      fail(place, "joint: " + quoted(word) + " is the name of " +
                      std::to_string(repeats_.at(word) + 1) + " joints, use an index from 0");
    if (const auto at = joints_.find(word); at != joints_.end()) return at->second;
    const auto index = parse_integer(word);
    if (index && *index >= 0 && static_cast<std::size_t>(*index) < framework_.joint_count())
      return static_cast<Joint>(*index);
    fail(place, "joint: no joint is named " + quoted(word));
  }

  /// A word by which find() finds that joint: its name if it has one of its own, else its index.
  /// Throws InputError where even the index is the name of other joints.
  std::string word_for(Joint joint) const {
    if (framework_.atoms()) {
      const std::string& name = framework_.atoms()->names[joint];
      if (!repeats_.contains(name) && split(name) == Words{name}) return name;
    }
    const std::string index = std::to_string(joint);
    if (joints_.contains(index))
      throw InputError("force file: " + framework_.label(joint) + " has no name of its own, and " +
                       "its index " + index + " is the name of another joint");
    return index;
  }

 private:
  const Framework& framework_;
  std::unordered_map<std::string_view, Joint> joints_;
  std::unordered_map<std::string_view, std::size_t> repeats_;
};

/// Reads a force file line by line.
class Parser {
 public:
  Parser(std::string_view file, const Framework& framework)
      : place_{file, 0}, framework_(framework), names_(framework) {}

  ForceFile parse(std::string_view text) {
    for (std::size_t i = 0; i <= text.size();) {
      const std::size_t end = std::min(text.find('\n', i), text.size());
      ++place_.line;
      take(split(text.substr(i, end - i)), text.substr(i, end - i));
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
  const Framework& framework_;
  JointNames names_;
  bool headed_ = false;
  ForceFile found_;
};

}  // namespace

Joint joint_named(const Framework& framework, std::string_view word, const Place& place) {
  return JointNames(framework).find(word, place);
}

ForceFile parse_force_file(std::string_view text, std::string_view file_name,
                           const Framework& framework) {
  return Parser(file_name, framework).parse(text);
}

ForceFile read_force_file(const std::filesystem::path& path, const Framework& framework) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    throw FileError(path.string() +
                    ": cannot be read: " + (error ? error.message() : "not a regular file"));
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw FileError(path.string() + ": cannot be opened for reading");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse_force_file(text, path.string(), framework);
}

std::string write_force_file(const ForceFile& forces, const Framework& framework) {
  const JointNames names(framework);
  std::string text = std::string(heading) + "\n";
  const auto setting = [&](const char* name, const std::optional<double>& value) {
    if (value) text += std::string(name) + " " + shortest(*value) + "\n";
  };
  setting("timestep", forces.timestep);
  setting("tolerance", forces.tolerance);
  setting("tolerance_length", forces.tolerance_length);
  if (forces.max_sweeps) text += "max_sweeps " + std::to_string(*forces.max_sweeps) + "\n";
  for (const JointForce& push : forces.pushes) {
    text += "push " + names.word_for(push.joint) + " " + shortest(push.force.x) + " " +
            shortest(push.force.y) + " " + shortest(push.force.z) + "\n";
  }
  return text;
}

}  // namespace pliant
