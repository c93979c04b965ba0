// SPDX-License-Identifier: MIT
// The table of the options of a sample: the command's options, Python's keywords, the page's
// settings, what files keep and `--continue` reads back, and check() all come from it. An option is
// added here, and where it is used.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/option_fields.hpp"
#include "pliant/sample/sample_options.hpp"

namespace pliant {

/// What is given in place of a sampler to leave it to the task.
inline constexpr std::string_view automatic_sampler = "auto";

using SampleField = OptionField<SampleOptions>;

/// In the order in which help lists them.
std::span<const SampleField> sample_fields();

/// The options of one who gives none: what a task can choose is left to it.
SampleOptions unset_sample_options();

/// Options by their paths below /parameters: "sample/seed".
std::vector<NamedParameter> parameters_of(const SampleOptions& options);

/// Recorded options by the names and in the units of today: version 0.3.0 wrote contact_energy as
/// sample/temperature, in kJ/mol.
std::vector<NamedParameter> renewed(std::vector<NamedParameter> parameters);

/// The inverse of parameters_of(), of any version; ranges are check()'s matter. Throws InputError
/// naming a path that is missing or has an invalid value.
SampleOptions sample_options_from(std::vector<NamedParameter> parameters);

}  // namespace pliant
