// SPDX-License-Identifier: MIT
// Symmetries of a small molecule: which of its heavy atoms may change places. By elements, bonds
// and hydrogens; terminal O, N and S of one atom are alike whatever they bear, as in acids, nitro
// groups and amidines.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/conformers/rings/bond_chemistry.hpp"

namespace pliant {

struct Symmetries {
  std::vector<Joint> heavy;  ///< (n) atoms other than hydrogen, ascending
  /// Each (n): the place of heavy atom k goes to that of heavy atom map[k]. The first changes
  /// nothing.
  std::vector<std::vector<std::uint32_t>> maps;
  bool is_complete = true;  ///< false: there are more
};

/// Finds at most `most` of them, by refinement of classes of atoms and backtracking (B. D. McKay,
/// Congr. Numer. 30 (1981) 45).
Symmetries symmetries(const Framework& framework, const BondChemistry& chemistry,
                      std::size_t most = 64);

}  // namespace pliant
