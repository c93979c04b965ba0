// SPDX-License-Identifier: MIT
#include "pliant/jobs/asked/conformer_options.hpp"

#include <algorithm>

namespace pliant {
namespace {

constexpr std::int64_t usual_candidates = 500, candidates_each = 2;
constexpr double most_megabytes = 1e9;      // of a library one record at a time is in memory
constexpr double largest_seed = INT32_MAX;  // that RDKit takes

template <auto Member>
constexpr auto at = place_at<ConformerOptions, Member>;

/// What is done where that is not said.
const std::string frames_text = std::to_string(usual_candidates) + ", or " +
                                std::to_string(candidates_each) + " for each conformer asked for";

const OptionField<ConformerOptions> table[] = {
    {{.name = "max",
      .letter = 'n',
      .summary = "conformers of a molecule, at most",
      .range = Range::positive},
     at<&ConformerOptions::max>},
    {{.name = "frames",
      .summary = "candidates drawn of a molecule, from all starts together",
      .range = Range::positive,
      .is_optional = true,
      .unset_means = frames_text},
     at<&ConformerOptions::frames>},
    {{.name = "starts",
      .summary = "structures with lengths and angles of their own to draw from; 1: the input alone",
      .range = Range::positive},
     at<&ConformerOptions::starts>},
    {{.name = "rms",
      .summary = "leave out conformers this near to a better one, Angstrom (heavy atoms); 0: none",
      .range = Range::zero_or_more},
     at<&ConformerOptions::rms>},
    {{.name = "window",
      .summary = "leave out what is further above the lowest energy, kcal/mol; 0: nothing",
      .range = Range::positive,
      .is_optional = true,
      .unset_means = "keep all"},
     at<&ConformerOptions::window>},
    {{.name = "energy",
      .summary = "rank by own (penalises unusual torsions and close atoms), MMFF94s or UFF (of\n"
                 "RDKit), auto (own with torsions and damped charges of MMFF94s where RDKit is\n"
                 "installed, else own), GFN2 (xTB in water, by tblite, of those that auto\n"
                 "chooses), none, or a force field of OpenMM (FILE.xml)",
      .kind = "NAME"},
     at<&ConformerOptions::energy>},
    {{.name = "minimise",
      .summary = "minimise by the energy: lengths and angles are then the force field's"},
     at<&ConformerOptions::minimise>},
    {{.name = "embed", .summary = "make drawings, and molecules without hydrogens, 3-D by RDKit"},
     at<&ConformerOptions::embed>},
    {{.name = "amides", .summary = "draw secondary amides as cis and trans"},
     at<&ConformerOptions::amides>},
    {{.name = "seed", .summary = "seed", .range = Range::zero_or_more, .largest = largest_seed},
     at<&ConformerOptions::seed>},
    {{.name = "smiles",
      .summary = "instead of FILE: one molecule, made 3-D by RDKit; with a ligand's FILE: its\n"
                 "bond orders, charges and hydrogens",
      .in_python = "Bond orders, charges and hydrogens of a Structure or one ligand are those of\n"
                   "this SMILES, and heavy atoms stay where they are. Without it RDKit guesses\n"
                   "orders that are not known from the hydrogens, if all are there.",
      .type_in_python = "str | None"},
     at<&ConformerOptions::smiles>},
    {{.name = "max_input",
      .summary = "largest file accepted, in megabytes, also once it is decompressed",
      .range = Range::positive,
      .largest = most_megabytes,
      .unit = "megabytes"},
     at<&ConformerOptions::max_input>},
    {{.name = "threads",
      .summary = "how many cores are used; changes no result",
      .range = Range::positive,
      .most = 1024,
      .unset_means = "all",
      .users = {.file = false}},
     at<&ConformerOptions::threads>},
};

}  // namespace

std::span<const OptionField<ConformerOptions>> conformer_fields() { return table; }

void check(const ConformerOptions& options) {
  for (const auto& field : conformer_fields()) check_option(field, field.place(places_of(options)));
}

void settle(ConformerOptions& options) {
  check(options);
  if (options.frames == 0)
    options.frames = std::max(usual_candidates, candidates_each * options.max);
}

}  // namespace pliant
