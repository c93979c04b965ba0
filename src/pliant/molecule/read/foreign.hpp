// SPDX-License-Identifier: MIT
// Recognizes files given by mistake, so that messages can say what they are.
#pragma once

#include <string_view>

namespace pliant {

/// What a file that is no molecule in text is by its first bytes, and what to do about it: "a web
/// page (HTML), perhaps from a failed download". Empty if not known.
std::string_view foreign_content(std::string_view text);

/// The program or format of an extension (".gro", in lower case) that is known but cannot be read:
/// "GROMACS (Gromos87)". Empty otherwise.
std::string_view foreign_format(std::string_view extension);

}  // namespace pliant
