// SPDX-License-Identifier: MIT
// Density maps to files.
#pragma once

#include <filesystem>
#include <string>

#include "pliant/fit/map/density_map.hpp"

namespace pliant {

/// The bytes of a map in MRC2014 format: mode 2, little endian, axes x, y, z, with its origin in
/// words 50 to 52. Cells keep lengths and angles, not how they are turned: the first step of the
/// map must be along x and the second in the plane of x and y, else InputError is thrown.
std::string map_bytes(const DensityMap& map);

/// Writes a complete file or none at all. Throws FileError as OutputFile does, InputError as
/// map_bytes() does.
void write_map(const std::filesystem::path& path, const DensityMap& map, bool overwrite);

}  // namespace pliant
