// SPDX-License-Identifier: MIT
// The report of pliant rigidity on a graph: a table to read, CSV and JSON.
#pragma once

#include <string>

#include "output/json.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/rigidity/framework_rigidity.hpp"

namespace pliant::app {

/// All that was found of one graph.
struct GraphRigidityReport {
  std::string file;
  Framework framework;
  FrameworkRigidity found;
};

void print_rigidity(const GraphRigidityReport& report);
/// One line for each bar.
std::string bars_as_csv(const GraphRigidityReport& report);
Json json_of_rigidity(const GraphRigidityReport& report);

}  // namespace pliant::app
