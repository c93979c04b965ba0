// SPDX-License-Identifier: MIT
// The options of pliant lab structgen.
#pragma once

#include <string>

#include "command_line.hpp"
#include "pliant/lab/test_sets/make_test_set.hpp"
#include "pliant/lab/test_sets/test_set.hpp"

namespace pliant::app {

struct StructgenSettings {
  std::string kind;         ///< the class of a single graph
  std::string output;       ///< graph XML; "": the class' name with .xml, in the current folder
  std::int64_t number = 0;  ///< number of the graph in its class
  std::string directory;    ///< of a test set; "": a single graph
  TestSetOptions set;       ///< with the seed and the sizes of a single graph, too
  bool overwrite = false;
  bool json = false;
};

void add_structgen_options(CommandLine& line, StructgenSettings& settings);

/// Sets what was left open. Throws OptionError for options that a single graph or a test set does
/// not have.
void complete(const CommandLine& line, StructgenSettings& settings);

}  // namespace pliant::app
