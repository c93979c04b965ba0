// SPDX-License-Identifier: MIT
// Values of options as text: as files keep them, and as they are read back to the same bits.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// Sets an option from text. Throws OptionError naming the option, what was expected and the text.
void set_value(std::string_view name, std::string_view text, bool& place);
void set_value(std::string_view name, std::string_view text, std::int64_t& place,
               std::int64_t least = std::numeric_limits<std::int64_t>::min());
void set_value(std::string_view name, std::string_view text, std::uint64_t& place);
void set_value(std::string_view name, std::string_view text, double& place);
void set_value(std::string_view name, std::string_view text, std::string& place);
/// Names with commas between them.
void set_value(std::string_view name, std::string_view text, std::vector<std::string>& place);

/// The text that set_value() reads back.
std::string value_text(bool value);
std::string value_text(std::int64_t value);
std::string value_text(std::uint64_t value);
std::string value_text(double value);
std::string value_text(const std::string& value);
std::string value_text(const std::vector<std::string>& names);
/// All words in a row, " | " between them: for people.
std::string value_text(const std::vector<std::vector<std::string>>& groups);

}  // namespace pliant
