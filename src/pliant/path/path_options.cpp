// SPDX-License-Identifier: MIT
#include "pliant/path/path_options.hpp"

#include "pliant/base/choices.hpp"

namespace pliant {
namespace {

constexpr PathAtoms table_of_atoms[] = {
    {.name = "CA", .are_heavy = false, .arrived_within = 0.5},
    {.name = "heavy", .are_heavy = true, .arrived_within = 1.0}};

template <auto Member>
constexpr auto at = place_at<PathOptions, Member>;

constexpr OptionField<PathOptions> table[] = {
    {{.name = "atoms",
      .summary = "which atoms have to reach END: one per residue, or all but H",
      .choices = [] { return names_of(path_atoms()); },
      .kind = "atoms",
      .in_python = "Which are asked to arrive: ``CA`` (P of nucleotides) or ``heavy``, those of\n"
                   "matched residues that have the same name."},
     at<&PathOptions::atoms>},
    {{.name = "step",
      .summary = "r.m.s. distance of a step, Angstrom",
      .range = Range::positive,
      .largest = 2.0,
      .unit = "Angstrom",
      .in_python = "r.m.s. distance of a step, Angstrom, above 0, at most 2."},
     at<&PathOptions::step>},
    {{.name = "both",
      .summary = "move both towards each other; START then retraces END's frames to END",
      .in_python = "Both structures go towards each other first."},
     at<&PathOptions::both>},
    {{.name = "backtrack",
      .summary = "if the path gets stuck, go back and try a detour, at most N times",
      .range = Range::zero_or_more,
      .largest = 1000.0,
      .in_python = "How often to go back and try a detour where the path is stuck, 0 to 1000."},
     at<&PathOptions::backtrack>},
    {{.name = "seed", .summary = "seed of the detours", .in_python = "Of the detours."},
     at<&PathOptions::seed>},
};

}  // namespace

std::span<const PathAtoms> path_atoms() { return table_of_atoms; }

const PathAtoms& find_path_atoms(std::string_view name) {
  return choose(path_atoms(), "atoms", name);
}

std::span<const OptionField<PathOptions>> path_fields() { return table; }

std::vector<NamedParameter> parameters_of(const PathOptions& options) {
  return option_parameters("path", path_fields(), options);
}

void check(const PathOptions& options) {
  for (const OptionField<PathOptions>& field : path_fields())
    check_option(field, field.place(places_of(options)));
}

}  // namespace pliant
