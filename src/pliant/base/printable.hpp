// SPDX-License-Identifier: MIT
// Text from outside (names of files, what files hold) made safe to print to a terminal.
#pragma once

#include <string>
#include <string_view>

namespace pliant {

/// `text` with control characters (except tab and line end) and bytes that are not UTF-8 written as
/// \xNN, so that no terminal obeys them. Letters of all scripts are kept.
std::string printable(std::string_view text);

/// A file's name as messages show it: unchanged, or in double quotes with \xNN where it holds
/// double quotes, tabs, line ends or characters that printable() escapes.
std::string printable_name(std::string_view name);

}  // namespace pliant
