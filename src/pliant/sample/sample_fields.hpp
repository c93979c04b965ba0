// SPDX-License-Identifier: MIT
// The table of the options of a sample, from which come the command's options, Python's keywords,
// the page's settings, the parameters of files that `--continue` reads, and check().
#pragma once

#include <span>
#include <vector>

#include "pliant/base/option_fields.hpp"
#include "pliant/sample/sample_options.hpp"

namespace pliant {

/// The value of the option `sampler` that lets the task choose.
inline constexpr std::string_view automatic_sampler = "auto";

using SampleField = OptionField<SampleOptions>;

/// In the order in which help lists them.
std::span<const SampleField> sample_fields();

/// Default options, with `auto` wherever the task can choose.
SampleOptions unset_sample_options();

/// Options by their paths below /parameters: "sample/seed".
std::vector<NamedParameter> parameters_of(const SampleOptions& options);

/// Reads options that parameters_of() wrote; check() checks their ranges. Throws InputError naming
/// a path that is missing or has an invalid value.
SampleOptions sample_options_from(const std::vector<NamedParameter>& parameters);

}  // namespace pliant
