// SPDX-License-Identifier: MIT
// What a force file of version 3 says before its forces: what they were made for.
//
//   pliant-forces 3
//   structure 5f0c1d3a9b7e2468   # fingerprint of the structure as it was read
//   joints 746                   # of the framework
//   bars 1490
//   input model protein          # an option that makes the framework of the structure
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Name and value of an option, as text; checked where it is used.
struct ForceSetting {
  std::string name, value;
  std::size_t line = 0;  ///< of the file, from 1; 0: of none
};

/// What is left out is not known.
struct ForceHeader {
  int version = 3;  ///< 1 and 2 have no header
  std::optional<std::uint64_t> structure;
  std::optional<std::int64_t> joints, bars;
  std::vector<ForceSetting> input;  ///< those that are not as usual, and what holds a molecule

  bool empty() const { return !structure && !joints && !bars && input.empty(); }
};

/// The numbers of joints and bars of a framework; nothing else is known of it.
ForceHeader force_header_of(const Framework& framework);

/// The lines of a header, with the first one of the file.
std::string write_force_header(const ForceHeader& header);

/// The first lines of a force file of any version, without a look at its forces. Throws InputError
/// naming file, line and what was expected.
ForceHeader read_force_header(std::string_view text, std::string_view file);

/// What a header says that a framework has not: "746 joints, not 683"; "": it fits.
std::string misfit(const ForceHeader& header, const Framework& framework);

/// Throws InputError naming the file unless the header fits.
void check_fit(const ForceHeader& header, const Framework& framework, std::string_view file);

/// Whether a text holds events (force_events.hpp): all of version 2, and those of version 3 that
/// hold more than settings and pushes.
bool has_force_events(std::string_view text);

}  // namespace pliant
