// SPDX-License-Identifier: MIT
// The choice between alternate locations (altlocs, conformers) of one residue.
#pragma once

#include <string_view>
#include <vector>

namespace pliant {

/// One listed atom of a residue that has alternate locations.
struct AltlocAtom {
  std::string_view name;
  char conformer;  ///< ' ' for none
  float occupancy;
};

/// Whether each atom is kept. Conformers that share no atom name do not compete: both can be kept.
/// An atom without a conformer is kept unless a chosen conformer has its name. O(N log N) for a
/// number of conformers that is bounded by the number of characters.
std::vector<bool> choose_altlocs(const std::vector<AltlocAtom>& atoms);

}  // namespace pliant
