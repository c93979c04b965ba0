// SPDX-License-Identifier: MIT
// The results of pliant rigidity as JSON: for programs, and for its page.
#pragma once

#include "output/json.hpp"
#include "output/rigidity_report.hpp"

namespace pliant::app {

/// All results.
Json json_of_rigidity(const RigidityReport& report);

/// All results with the molecule and the dilution plot, as pliant-rigidity-page reads them.
Json json_for_page(const RigidityReport& report);

}  // namespace pliant::app
