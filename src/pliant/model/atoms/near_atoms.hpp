// SPDX-License-Identifier: MIT
// Finds atoms near given atoms with a cell list, in linear time.
#pragma once

#include <cstdint>
#include <span>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// For each of `centres` (in their order) the atoms of `others` within `reach` Angstrom, ascending,
/// without the centre itself. Neither list may contain an atom twice.
Grouped<std::uint32_t> near_atoms(const Structure& structure,
                                  std::span<const std::uint32_t> centres,
                                  std::span<const std::uint32_t> others, double reach);

}  // namespace pliant
