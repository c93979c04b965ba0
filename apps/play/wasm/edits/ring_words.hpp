// SPDX-License-Identifier: MIT
// The ring that an atom is part of, in words.
#pragma once

#include <string>

#include "document.hpp"

namespace pliant::play {

/// "the ring of PRO19", or "a ring of 6 atoms" where these are of several residues; "" if no ring
/// of bonds of at most 8 atoms has the joint, and of a graph.
std::string ring_text(const Document& document, Joint joint);

}  // namespace pliant::play
