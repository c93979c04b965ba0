// SPDX-License-Identifier: MIT
#include "pliant/jobs/asked/input_options.hpp"

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/model/prepare/select_part.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"

namespace pliant {
namespace {

constexpr std::string_view group = "Molecule";
constexpr std::int64_t most_models = 1'000'000'000;

template <auto Member>
constexpr auto at = place_at<InputOptions, Member>;

constexpr OptionField<InputOptions> table[] = {
    {{.name = "frame",
      .group = group,
      .summary = "which model, frame or record of the file",
      .range = Range::positive,
      .most = most_models,
      .users = {.python = false},
      .recorded = "input/model"},
     at<&InputOptions::frame>},
    {{.name = "assembly",
      .group = group,
      .summary = "build biological assembly N, as the file describes it",
      .kind = "N",
      .in_python = "Biological assembly to build of the file at a path, as for ``read``.",
      .type_in_python = "int | str | None"},
     at<&InputOptions::assembly>},
    {{.name = "select",
      .group = group,
      .summary = "use only these atoms, such as \"protein\" or \"not resname HOH\"",
      .kind = "SELECTION",
      .in_python = "Selection of atoms to take, as for ``Structure.select``."},
     at<&InputOptions::select>},
    {{.name = "max_input",
      .group = group,
      .summary = "largest file accepted, in megabytes, also once it is decompressed",
      .range = Range::positive,
      .most = largest_text / 1'000'000,
      .users = {.python = false, .file = false}},
     at<&InputOptions::max_input>},
    {{.name = "distance_bonds",
      .group = group,
      .summary = "do not guess bonds from distances",
      .in_python = "Guess bonds from distances where the file has none.",
      .opposite = "no_distance_bonds",
      .users = {.python = false}},
     at<&InputOptions::distance_bonds>},
};

}  // namespace

std::span<const OptionField<InputOptions>> input_fields() { return table; }

std::string input_bytes(const InputOptions& options) {
  try {
    return read_bytes(path_of(options.file),
                      static_cast<std::size_t>(options.max_input) * 1'000'000);
  } catch (const TooLargeError& error) {
    throw OptionError(std::string(error.what()) + "; --max-input allows more");
  }
}

Structure read_input(const InputOptions& options, const Log& log) {
  ReadOptions reading;
  reading.model = static_cast<std::size_t>(options.frame);
  reading.assembly = options.assembly;
  reading.log = log;
  const std::string bytes = input_bytes(options);
  Structure structure = read_structure(SourceText{options.file, bytes}, reading);
  BondOptions bonding;
  bonding.guess_distances = options.distance_bonds;
  bonding.log = log;
  perceive_bonds(structure, bonding);
  return options.select.empty() ? structure : select_part(structure, options.select, log);
}

}  // namespace pliant
