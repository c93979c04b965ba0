// SPDX-License-Identifier: MIT
// Bonds by distance: a step of bond perception. Not for users: see bonds.hpp.
#pragma once

#include "pliant/molecule/bonds/perception.hpp"

namespace pliant::perception {

/// Bonds by distance where templates and the file leave something open.
void add_distance_bonds(Perception& perception);

}  // namespace pliant::perception
