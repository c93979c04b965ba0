// SPDX-License-Identifier: MIT
// Bonds between residues: a step of bond perception. Not for users: see bonds.hpp.
#pragma once

#include "pliant/molecule/bonds/perception.hpp"

namespace pliant::perception {

/// Bonds between pieces: peptide C-N and O3'-P of consecutive pieces, rings closed by them, and
/// disulphides.
void add_links(Perception& perception);

}  // namespace pliant::perception
