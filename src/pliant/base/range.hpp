// SPDX-License-Identifier: MIT
// Ranges of options: what a number may be, and how a refusal says so. The command, the library and
// Python ask here.
#pragma once

#include <cstdint>
#include <string_view>

namespace pliant {

/// What a number may be. A real number is finite in any case.
enum class Range : std::uint8_t { any, positive, zero_or_more, zero_to_one };

bool holds(Range range, double value);
bool holds(Range range, std::int64_t value);

/// Throws OptionError "weighting = 1.5: must be from 0 to 1" if `value` is out of `range`.
void check_range(std::string_view name, double value, Range range);
/// The same: "max_sweeps = 0: must be from 1".
void check_range(std::string_view name, std::int64_t value, Range range);

}  // namespace pliant
