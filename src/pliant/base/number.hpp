// SPDX-License-Identifier: MIT
// The one strict number parser of every reader: the whole field must be a finite decimal number,
// neither hexadecimal nor nan nor inf, with a decimal point. Also the one printer of numbers in
// messages. Neither follows the locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pliant {

/// Whether `c` is one of 0 to 9, whatever the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// `text` without leading and trailing blanks and tabs.
std::string_view trimmed(std::string_view text);

/// Returns the finite real number that fills `text` (blanks around it are allowed): "1.5", "+.5",
/// "1e-3", or Fortran's "1.0D+00". Nothing for anything else, and on overflow.
std::optional<double> parse_real(std::string_view text);

/// Returns the decimal integer that fills `text` (blanks around it are allowed). Nothing on
/// overflow.
std::optional<std::int64_t> parse_integer(std::string_view text);

/// `value` with at most `digits` significant digits, as printf's %g writes it in the C locale:
/// "1.5", "1e-07", "nan".
std::string number_text(double value, int digits = 10);

/// `value` with the fewest digits that parse_real reads back to the same bits: "0.1", "1e-300",
/// "-0".
std::string shortest_text(double value);

}  // namespace pliant
