// SPDX-License-Identifier: MIT
#include "recorded_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/laboratory/recorded_inputs.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant::app {
namespace {

/// An option and the path below /parameters where it is recorded.
struct RecordedOption {
  const char* option;
  const char* path;
};

constexpr RecordedOption recorded_options[] = {{"input", "input/file"},
                                               {"--frame", "input/model"},
                                               {"--bars", "input/bars"},
                                               {"--lengths", "input/lengths"},
                                               {"--pin", "input/pin"},
                                               {"--no-distance-bonds", "input/distance_bonds"},
                                               {"--hbond-cutoff", "model/hbond_cutoff"},
                                               {"--contacts", "model/contacts"},
                                               {"--keep-waters", "model/keep_waters"},
                                               {"--protonate", "model/protonate"},
                                               {"--floppy", "model/floppy"},
                                               {"--ordering", "run/ordering"},
                                               {"--forces", "run/forces"},
                                               {"--single", "record/single"},
                                               {"--compress", "record/compress"}};

/// Options of a new file.
constexpr const char* options_of_a_new_run[] = {"--format", "--topology", "--overwrite",
                                                "--record-forces"};

const Parameter* find(const std::vector<NamedParameter>& parameters, const std::string& path) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const NamedParameter& one) { return one.first == path; });
  return found == parameters.end() ? nullptr : &found->second;
}

struct Shown {
  std::string operator()(bool value) const { return value ? "yes" : "no"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return shortest_text(value); }
  std::string operator()(const std::string& value) const {
    return value.empty() ? "none" : value.size() > 200 ? value.substr(0, 200) : value;
  }
};

/// Compares what is given again with what the file says.
class Comparison {
 public:
  Comparison(const CommandLine& line, const RunSettings& given, const H5mdCheckpoint& recorded)
      : line_(line),
        recorded_(recorded),
        given_(parameters_of(given, recorded.framework, given.first_walker)) {}

  void check(const std::string& option, const std::string& path) const {
    if (!line_.was_given(option)) return;
    const Parameter* given = find(given_, path);
    const Parameter* recorded = find(recorded_.parameters, path);
    if (given != nullptr && recorded != nullptr && *given == *recorded) return;
    const std::string name = option.starts_with("--") ? option : "FILE";
    throw OptionError(fmt::format("{}: is {} in the run of {}, not {}; a run goes on as it began",
                                  name, recorded ? std::visit(Shown(), *recorded) : "not set",
                                  recorded_.path.string(),
                                  given ? std::visit(Shown(), *given) : "that"));
  }

  /// A number is that of a model of the file, a name that of a kind of model.
  void check_model() const {
    const Parameter* kind = find(given_, "model/kind");
    check("--model", kind == nullptr ? "input/model" : "model/kind");
  }

 private:
  const CommandLine& line_;
  const H5mdCheckpoint& recorded_;
  std::vector<NamedParameter> given_;
};

std::string option_of(const RunField& field) {
  std::string option = "--" + std::string(field.name);
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

}  // namespace

void check_options_again(const CommandLine& line, const RunSettings& given,
                         const H5mdCheckpoint& recorded) {
  for (const char* option : options_of_a_new_run)
    if (line.was_given(option))
      throw OptionError(std::string(option) + ": does not go with --continue, which adds to " +
                        recorded.path.string());
  const Comparison comparison(line, given, recorded);
  for (const RunField& field : run_fields())
    if (field.name != "steps") comparison.check(option_of(field), "run/" + std::string(field.name));
  for (const auto& [option, path] : recorded_options) comparison.check(option, path);
  comparison.check_model();
}

RunOptions options_of(const H5mdCheckpoint& recorded) {
  RunOptions options;
  try {
    options = run_options_from(recorded.parameters);
    options.replay = replay_of(recorded.inputs);
    if (Ordering ordering = ordering_of(recorded.inputs); !ordering.empty())
      options.technique.ordering = std::make_shared<Ordering>(std::move(ordering));
    check(options);
  } catch (const Error& error) {
    throw InputError(recorded.path.string() + ": its run cannot go on: " + error.what());
  }
  options.steps = recorded.steps;
  return options;
}

}  // namespace pliant::app
