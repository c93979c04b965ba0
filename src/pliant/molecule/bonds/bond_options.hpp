// SPDX-License-Identifier: MIT
// Options of bond perception.
#pragma once

#include "pliant/base/log.hpp"

namespace pliant {

/// How bonds are perceived.
struct BondOptions {
  double slack = 0.45;          ///< Angstrom added to the sum of two covalent radii
  double shortest = 0.4;        ///< Angstrom; closer atoms are not bonded
  bool guess_distances = true;  ///< whether distances are used
  Log log = {};
};

}  // namespace pliant
