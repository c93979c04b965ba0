// SPDX-License-Identifier: MIT
// Atoms near some atoms, by a cell list: linear in their number.
#pragma once

#include <cstdint>
#include <span>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// For each of `centres` (in their order) those of `others` within `reach` Angstrom, ascending; an
/// atom is not near itself. Neither list names an atom twice.
Grouped<std::uint32_t> near_atoms(const Structure& structure,
                                  std::span<const std::uint32_t> centres,
                                  std::span<const std::uint32_t> others, double reach);

}  // namespace pliant
