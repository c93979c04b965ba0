// SPDX-License-Identifier: MIT
// Functions shared by all readers: strict coordinates, the choice of a model, and the final checks.
#pragma once

#include <cstddef>
#include <string_view>

#include "pliant/base/error.hpp"
#include "pliant/molecule/read/shared/read_options.hpp"
#include "pliant/molecule/read/shared/remarks.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Coordinates beyond this (Angstrom) are refused: a double resolves 1e-7 Angstrom there.
inline constexpr double largest_coordinate = 1e9;

/// `text` as a coordinate in Angstrom; `field` names it in messages: "x (columns 31-38)".
/// Throws InputError on anything but a finite number within +-largest_coordinate.
double parse_coordinate(std::string_view text, const Place& place, std::string_view field);

/// Throws OptionError unless the file has the requested model; sets structure.model and
/// model_count; notes "frame 1 of 2 used" where there are several. `noun` is "model" or "frame".
void take_model_count(Structure& structure, std::size_t count, const ReadOptions& options,
                      std::string_view noun, Remarks& remarks);

/// Sorts bonds by (a, b) and merges equal pairs, keeping the highest order. Returns whether any
/// were merged.
bool sort_bonds(std::vector<Bond>& bonds);

/// Ends every reading: refuses a molecule whose atoms all lie at one point, warns of bonds between
/// atoms at one point, sets source and format, and reports the remarks.
Structure finish(Structure structure, const SourceText& source, std::string_view format,
                 Remarks& remarks);

}  // namespace pliant
