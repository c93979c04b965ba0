// SPDX-License-Identifier: MIT
#include "options/option_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"

namespace pliant::app {
namespace {

constexpr RecordedOption options_of_both[] = {{"input", "input/file"},
                                              {"--frame", "input/model"},
                                              {"--select", "input/select"},
                                              {"--assembly", "input/assembly"},
                                              {"--no-distance-bonds", "input/distance_bonds"},
                                              {"--hbond-cutoff", "model/hbond_cutoff"},
                                              {"--contacts", "model/contacts"},
                                              {"--more-contacts", "model/more_contacts"},
                                              {"--fill-side-chains", "model/fill_side_chains"},
                                              {"--all-hydrogens", "model/all_hydrogens"},
                                              {"--keep-waters", "model/keep_waters"},
                                              {"--keep", "model/keep"},
                                              {"--protonate", "model/protonate"},
                                              {"--floppy", "model/floppy"},
                                              {"--single", "record/single"},
                                              {"--compress", "record/compress"},
                                              {"--precision", "record/precision"},
                                              {"--save", "record/save"}};

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

}  // namespace

void refuse_options_of_a_new_file(const CommandLine& line, std::span<const char* const> options,
                                  const std::filesystem::path& file) {
  for (const char* option : options)
    if (line.was_given(option))
      throw OptionError(std::string(option) + ": does not go with --continue, which adds to " +
                        path_text(file));
}

void refuse_another_output(const CommandLine& line, const std::string& output,
                           const std::string& file) {
  std::error_code error;
  if (line.was_given("--output") &&
      !std::filesystem::equivalent(path_of(output), path_of(file), error) && output != file)
    throw OptionError("--output " + output + ": --continue adds to " + file + " itself");
}

OptionComparison::OptionComparison(const CommandLine& line, std::vector<NamedParameter> given,
                                   const H5mdCheckpoint& recorded)
    : line_(line), recorded_(recorded), given_(std::move(given)) {}

void OptionComparison::check(const std::string& option, const std::string& path) const {
  if (!line_.was_given(option)) return;
  const Parameter* given = find(given_, path);
  const Parameter* recorded = find(recorded_.parameters, path);
  if (given != nullptr && recorded != nullptr && *given == *recorded) return;
  const std::string name = option.starts_with("--") ? option : "FILE";
  throw OptionError(fmt::format("{}: is {} in the run of {}, not {}; a run goes on as it began",
                                name, recorded ? std::visit(Shown(), *recorded) : "not set",
                                path_text(recorded_.path),
                                given ? std::visit(Shown(), *given) : "that"));
}

void OptionComparison::check(std::span<const RecordedOption> options) const {
  for (const auto& [option, path] : options) check(option, path);
}

void OptionComparison::check_both() const {
  for (const auto& [option, path] : options_of_both) check(option, path);
}

void OptionComparison::check_model() const {
  const Parameter* kind = find(given_, "model/kind");
  check("--model", kind == nullptr ? "input/model" : "model/kind");
}

}  // namespace pliant::app
