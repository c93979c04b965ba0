// SPDX-License-Identifier: MIT
// Text from outside (names of files, what files hold) made safe to print to a terminal.
#pragma once

#include <string>
#include <string_view>

namespace pliant {

/// `text` with control characters (but tab and line end) and bytes that are no UTF-8 as \xNN, so
/// that no terminal takes them for orders. Letters of all scripts stay.
std::string printable(std::string_view text);

/// A file's name as messages have it: as it is, or in double quotes with \xNN where it holds
/// characters that printable() writes so, tabs, line ends or double quotes.
std::string printable_name(std::string_view name);

}  // namespace pliant
