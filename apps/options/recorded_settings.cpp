// SPDX-License-Identifier: MIT
#include "options/recorded_settings.hpp"

#include "options/option_comparison.hpp"
#include "options/option_fields.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant::app {
namespace {

constexpr RecordedOption recorded_options[] = {{"input", "input/file"},
                                               {"--frame", "input/model"},
                                               {"--select", "input/select"},
                                               {"--assembly", "input/assembly"},
                                               {"--bars", "input/bars"},
                                               {"--lengths", "input/lengths"},
                                               {"--pin", "input/pin"},
                                               {"--no-distance-bonds", "input/distance_bonds"},
                                               {"--hbond-cutoff", "model/hbond_cutoff"},
                                               {"--contacts", "model/contacts"},
                                               {"--fill-side-chains", "model/fill_side_chains"},
                                               {"--all-hydrogens", "model/all_hydrogens"},
                                               {"--keep-waters", "model/keep_waters"},
                                               {"--protonate", "model/protonate"},
                                               {"--floppy", "model/floppy"},
                                               {"--ordering", "run/ordering"},
                                               {"--forces", "run/forces"},
                                               {"--rock", "guide/rock"},
                                               {"--rock-amplitude", "guide/rock_amplitude"},
                                               {"--period", "guide/period"},
                                               {"--pull", "guide/pull"},
                                               {"--pair-distance", "guide/pair_distance"},
                                               {"--single", "record/single"},
                                               {"--compress", "record/compress"},
                                               {"--precision", "record/precision"},
                                               {"--save", "record/save"}};

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
  comparison.check(recorded_options);
  comparison.check_model();
}

}  // namespace pliant::app
