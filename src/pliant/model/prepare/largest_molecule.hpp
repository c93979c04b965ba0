// SPDX-License-Identifier: MIT
// Drops the counter-ions and waters of a small molecule in an SDF record.
#pragma once

#include "pliant/base/log.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Returns a structure read from SDF without all molecules but the largest: that with most heavy
/// atoms, then most atoms, then the first. A note says how many there were. Structures of other
/// formats, and those with one molecule, are returned unchanged. Bonds must be known.
Structure largest_molecule(const Structure& structure, const Log& log = {});

}  // namespace pliant
