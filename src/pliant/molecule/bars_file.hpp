// SPDX-License-Identifier: MIT
// Bars files: bars besides those of bonds, limits and sterics, stated line by line.
//
//   pliant-bars 1
//   bars bonds               # start with: bonds, angles or none (none if there is no such line)
//   bar C1 C7 1.53           # joints, length in Angstrom; by default that of the structure
//   limit C1 O4 2.5 inf      # joints, least and most distance in Angstrom
//   limit C2 O4 0 3.5 hydrogen_bond -12.5 3   # kind of limit, energy in kJ/mol, group
//   sterics C O 2.8          # least distance in Angstrom of joints of two kinds
//   kind C7 none             # kind of a joint; by default its element; none: it touches nothing
//   own C1 O4 2.1            # least distance in Angstrom of this pair, whatever its kinds
//   bonds_apart 3            # pairs up to this many bars apart never touch; 3 by default
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/sterics_lines.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {

/// Contents of a bars file. JointNames says how it refers to joints.
struct BarsFile {
  BarKind bars = BarKind::none;
  std::vector<StatedBar> stated = {};
  std::vector<Limit> limits = {};
  std::optional<NamedSterics> sterics = {};
};

/// Reads a bars file, using only the number and the names of `joints`. Throws InputError naming
/// file, line, what was expected and found; FileError if the file cannot be read.
BarsFile read_bars_file(const std::filesystem::path& path, const Framework& joints);
BarsFile parse_bars_file(const SourceText& source, const Framework& joints);

/// Returns text that parse_bars_file reads back to the same bits. Throws InputError as
/// JointNames::word_for does, and for sterics that no line can state: with units, with their own
/// bonds, or with kinds that parse_bars_file would number differently.
std::string write_bars_file(const BarsFile& file, const Framework& joints);

/// Whether --bars names a file rather than one of bar_choices, which take precedence.
bool is_bars_file(const std::string& bars);

/// Sets `options` from `bars`: a name in bar_choices, or else the path of a bars file for
/// `structure`. Throws as read_bars_file does; OptionError if it is neither.
void take_bars(const std::string& bars, const Structure& structure, BuildOptions& options);

}  // namespace pliant
