// SPDX-License-Identifier: MIT
// Density maps from MRC and CCP4 files.
#pragma once

#include <filesystem>
#include <string_view>

#include "pliant/fit/map/density_map.hpp"

namespace pliant {

/// Reads a map in MRC or CCP4 format, compressed or not, in modes 0, 1, 2, 6 and 12, in any order
/// of bytes and axes: what a header means is said at read_map_header(). What is outside of the box
/// is not repeated from the cell. Throws FileError with the system's reason; TooLargeError for
/// files beyond `largest_text` and maps of over `most_map_points`; InputError naming file, field,
/// what was expected and found, for densities that are not finite too.
DensityMap read_map(const std::filesystem::path& path);

/// The same from the bytes of a file; `name` is for messages.
DensityMap map_from(std::string_view bytes, std::string_view name);

}  // namespace pliant
