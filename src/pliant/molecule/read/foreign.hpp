// SPDX-License-Identifier: MIT
// Files that people give by mistake: what they are, so that messages can say so.
#pragma once

#include <string_view>

namespace pliant {

/// What a file is by its first bytes, if that is no molecule in text, and what to do about it:
/// "a web page (HTML), perhaps from a failed download". Empty: not known.
std::string_view foreign_content(std::string_view text);

/// The program or format that an extension (".gro", in lower case) belongs to, if it is known and
/// not read: "GROMACS (Gromos87)". Empty otherwise.
std::string_view foreign_format(std::string_view extension);

}  // namespace pliant
