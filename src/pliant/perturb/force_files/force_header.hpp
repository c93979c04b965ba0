// SPDX-License-Identifier: MIT
// The header of a force file: what its forces were made for.
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

/// Name and value of an option, as text; checked when it is used.
struct ForceSetting {
  std::string name, value;
  std::size_t line = 0;  ///< line of the file, from 1; 0 if not from a file
};

/// The header of a force file. Missing entries are not known.
struct ForceHeader {
  std::optional<std::uint64_t> structure;
  std::optional<std::int64_t> joints, bars;
  std::vector<ForceSetting> input;  ///< options that are not as usual, and what holds a molecule
};

/// A header with only the numbers of joints and bars of a framework.
ForceHeader force_header_of(const Framework& framework);

/// Returns the lines of a header, the first line of the file included.
std::string write_force_header(const ForceHeader& header);

/// Reads the first lines of a force file without reading its forces. Throws InputError naming file,
/// line and what was expected.
ForceHeader read_force_header(std::string_view text, std::string_view file);

/// How the framework differs from the header: "746 joints, not 683"; "" if it fits.
std::string misfit(const ForceHeader& header, const Framework& framework);

/// Throws InputError naming the file unless the header fits.
void check_fit(const ForceHeader& header, const Framework& framework, std::string_view file);

/// Whether a text holds events (force_events.hpp): more than settings and pushes.
bool has_force_events(std::string_view text);

}  // namespace pliant
