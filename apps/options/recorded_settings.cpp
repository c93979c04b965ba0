// SPDX-License-Identifier: MIT
#include "options/recorded_settings.hpp"

#include "options/option_comparison.hpp"
#include "options/option_fields.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant::app {
namespace {

constexpr RecordedOption options_of_runs[] = {{"--bars", "input/bars"},
                                              {"--lengths", "input/lengths"},
                                              {"--pin", "input/pin"},
                                              {"--ordering", "run/ordering"},
                                              {"--forces", "run/forces"},
                                              {"--rock", "guide/rock"},
                                              {"--rock-amplitude", "guide/rock_amplitude"},
                                              {"--period", "guide/period"},
                                              {"--pull", "guide/pull"},
                                              {"--pair-distance", "guide/pair_distance"}};

/// Options of a new file.
constexpr const char* options_of_a_new_run[] = {"--format", "--topology", "--overwrite",
                                                "--record-forces", "--imd"};

}  // namespace

void check_options_again(const CommandLine& line, const RunSettings& given,
                         const H5mdCheckpoint& recorded) {
  refuse_options_of_a_new_file(line, options_of_a_new_run, recorded.path);
  const OptionComparison comparison(
      line, parameters_of(given, recorded.framework, given.first_walker), recorded);
  for (const RunField& field : run_fields())
    if (field.name != "steps")
      comparison.check(option_name(field.name), "run/" + std::string(field.name));
  comparison.check_both();
  comparison.check(options_of_runs);
  comparison.check_model();
}

}  // namespace pliant::app
