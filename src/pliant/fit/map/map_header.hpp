// SPDX-License-Identifier: MIT
// The header of an MRC or CCP4 map (A. Cheng et al., J. Struct. Biol. 192 (2015) 146).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "pliant/fit/map/map_grid.hpp"

namespace pliant {

inline constexpr std::size_t map_header_size = 1024;

/// How densities are kept.
enum class MapMode : std::uint8_t { int8 = 0, int16 = 1, float32 = 2, uint16 = 6, float16 = 12 };

/// Bytes of a density.
std::size_t size_of(MapMode mode);

struct MapHeader {
  MapMode mode = MapMode::float32;
  bool is_big_endian = false;
  std::array<std::size_t, 3> count{};  ///< columns, rows and sections; columns run fastest
  std::array<std::size_t, 3> axis{};   ///< along which axis (0, 1, 2) each of these goes
  std::size_t densities = 0;           ///< where they begin in the file
  MapGrid grid;                        ///< along the axes of the cell
};

/// Reads the header of a file of which `bytes` are all; `name` is for messages. Throws InputError
/// naming the field, what was expected and what was found, also where the file is too short for its
/// densities.
///
/// The order of bytes is that of the machine stamp; without one, that in which all counts are below
/// 65536. The origin is that of words 50 to 52 if it is not 0 and the file is marked as MAP, else
/// nstart x spacing. Cells without angles are right-angled, axes that are all 0 are x, y, z, and
/// without intervals there are as many as points.
MapHeader read_map_header(std::string_view bytes, std::string_view name);

}  // namespace pliant
