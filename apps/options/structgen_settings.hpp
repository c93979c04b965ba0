// SPDX-License-Identifier: MIT
// The options of pliant structgen.
#pragma once

#include <string>

#include "command_line.hpp"
#include "pliant/laboratory/make_test_set.hpp"
#include "pliant/laboratory/test_set.hpp"

namespace pliant::app {

struct StructgenSettings {
  std::string kind;         ///< the class of the one graph
  std::string output;       ///< graph XML; "": the class' name with .xml, in the current folder
  std::int64_t number = 0;  ///< which of all graphs of the class
  std::string directory;    ///< of a test set; "": one graph
  TestSetOptions set;       ///< its settings hold seed and sizes of the one graph too
  bool overwrite = false;
  bool json = false;
};

void add_structgen_options(CommandLine& line, StructgenSettings& settings);

/// Fills in what was left open. Throws OptionError for what one graph and a test set do not share.
void complete(const CommandLine& line, StructgenSettings& settings);

}  // namespace pliant::app
