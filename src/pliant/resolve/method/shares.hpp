// SPDX-License-Identifier: MIT
// Shares of a bar's correction that its two joints take.
#pragma once

#include <utility>

#include "pliant/framework/framework.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

/// Shares (near, far) of a correction. They sum to 1, or are both 0 when both joints are pinned. A
/// pinned joint takes nothing, and its partner all.
std::pair<double, double> shares(const Technique& technique, const OrderedBar& visit,
                                 const Framework& framework);

/// Shares (a, b) of a correction between two joints without a bar: equal, or by inverse masses.
/// They sum to 1; a pinned joint takes nothing, and both are 0 when both are pinned.
std::pair<double, double> equal_shares(const Framework& framework, Joint a, Joint b,
                                       bool mass_weighted);

}  // namespace pliant
