// SPDX-License-Identifier: MIT
// Rings of six hinges: rigid by counting, although a boat can move.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "pliant/model/rigidity/rigidity_network.hpp"

namespace pliant {

/// Rings of six bonds with five bars each and no bond across, as in cyclohexane and sugars. By
/// counting, six hinges leave 6 - 6 = 0 freedoms, whatever the positions. At fixed lengths and
/// angles this is true of a chair, but a boat has one freedom and moves through twist-boats.
/// Returns the atoms in order round each ring, from the lowest. Linear in the number of atoms.
std::vector<std::array<std::uint32_t, 6>> rings_of_six(const RigidityNetwork& network);

/// How to read the count: "1 ring of six bonds that may turn: ..."; "" if there is no ring.
std::string note_on_rings_of_six(std::size_t rings);

}  // namespace pliant
