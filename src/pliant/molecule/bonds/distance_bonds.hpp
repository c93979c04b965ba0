// SPDX-License-Identifier: MIT
// Bonds by distance: a step of bond perception. Internal: users call bonds.hpp.
#pragma once

#include "pliant/molecule/bonds/perception.hpp"

namespace pliant::perception {

/// Adds bonds by distance for atoms whose bonds neither the file nor a template determines.
void add_distance_bonds(Perception& perception);

}  // namespace pliant::perception
