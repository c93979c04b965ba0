// SPDX-License-Identifier: MIT
// Ranges of options: which numbers are allowed, and how a refusal says so. The command, the library
// and Python all use them.
#pragma once

#include <cstdint>
#include <string_view>

namespace pliant {

/// Which numbers are allowed. A real number is finite in any case.
enum class Range : std::uint8_t { any, positive, zero_or_more, zero_to_one };

bool holds(Range range, double value);
bool holds(Range range, std::int64_t value);

/// Throws OptionError "weighting = 1.5: must be from 0 to 1" if `value` is out of `range`.
void check_range(std::string_view name, double value, Range range);
/// The same for a whole number: "max_sweeps = 0: must be from 1".
void check_range(std::string_view name, std::int64_t value, Range range);

}  // namespace pliant
