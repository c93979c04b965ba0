// SPDX-License-Identifier: MIT
// What pliant rigidity found as JSON: for programs, and for its page.
#pragma once

#include "output/json.hpp"
#include "output/rigidity_report.hpp"

namespace pliant::app {

/// All that was found.
Json json_of_rigidity(const RigidityReport& report);

/// The same, with the molecule and the dilution plot: what pliant-rigidity-page reads.
Json json_for_page(const RigidityReport& report);

}  // namespace pliant::app
