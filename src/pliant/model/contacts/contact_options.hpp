// SPDX-License-Identifier: MIT
// What finders of contacts can be asked for.
#pragma once

namespace pliant {

struct HydrogenBondOptions {
  double cutoff = -1.0;  ///< kcal/mol: bonds of no lower energy are left out
};

struct TetherOptions {
  double reach = 0.5;  ///< Angstrom beyond the sum of radii
};

/// The options of all finders.
struct ContactOptions {
  HydrogenBondOptions hydrogen_bonds = {};
  TetherOptions tethers = {};
};

}  // namespace pliant
