// SPDX-License-Identifier: MIT
// Standard bond lengths by element pair and bond order.
#pragma once

#include <cstdint>
#include <optional>

namespace pliant {

/// The standard length (Angstrom) of a bond of `order` (1, 2, 3; 4 aromatic) between two elements,
/// in either order. Order 0 (unknown) counts as 1 for elements that make only single bonds. Nothing
/// where the table has no such bond. After Allen et al., J. Chem. Soc. Perkin Trans. 2 1987, S1;
/// bonds such as C-H as in gas-phase molecules.
std::optional<double> standard_bond_length(std::uint8_t element_a, std::uint8_t element_b,
                                           std::uint8_t order);

}  // namespace pliant
