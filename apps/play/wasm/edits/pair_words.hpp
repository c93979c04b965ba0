// SPDX-License-Identifier: MIT
// What joins two joints, in words.
#pragma once

#include <string>
#include <vector>

#include "document.hpp"

namespace pliant::play {

/// "hydrogen bond", "bond", "angle", "planar group", "bar", "limit"; "" if nothing joins them.
/// `document` is the one at the start, whose contacts have the numbers of groups of limits.
std::string what_joins(const Document& document, const Framework& now, Joint a, Joint b);

/// The pairs of joints whose bars keep the bond of a and b from turning.
std::vector<FrameworkEdit> bars_across(const Document& document, const Framework& now, Joint a,
                                       Joint b);

/// "hydrogen bond GLY10:N – VAL17:O".
std::string pair_text(const Document& document, const Framework& now, Joint a, Joint b);

}  // namespace pliant::play
