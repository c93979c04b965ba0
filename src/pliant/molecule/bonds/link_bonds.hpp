// SPDX-License-Identifier: MIT
// Bonds between residues: a step of bond perception. Internal: users call bonds.hpp.
#pragma once

#include "pliant/molecule/bonds/perception.hpp"

namespace pliant::perception {

/// Adds bonds between pieces: peptide C-N and O3'-P of consecutive pieces, the same bonds where
/// they close a ring, and disulphides.
void add_links(Perception& perception);

}  // namespace pliant::perception
