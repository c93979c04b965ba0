// SPDX-License-Identifier: MIT
// Rings of six hinges: what a count of freedoms calls rigid, though a boat moves.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "pliant/model/rigidity/rigidity_network.hpp"

namespace pliant {

/// Rings of six bonds with five bars each, without a bond across: cyclohexane, sugars. Six hinges
/// leave 6 - 6 = 0 freedoms, whatever the positions. At fixed lengths and angles a chair has none
/// indeed; a boat has one, and goes through twist-boats. Atoms in order round the ring, from the
/// lowest. Linear in the number of atoms.
std::vector<std::array<std::uint32_t, 6>> rings_of_six(const RigidityNetwork& network);

/// "1 ring of six bonds that may turn: ...": what to think of the count; "" where there is none.
std::string told_of_rings_of_six(std::size_t rings);

}  // namespace pliant
