// SPDX-License-Identifier: MIT
// The atoms that a macromolecular file lists, before one conformer of each residue is chosen.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "pliant/molecule/read/shared/remarks.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Columns of N listed atoms.
struct AtomSites {
  Structure structure;               ///< atoms, positions, charges, chain ends
  std::vector<char> conformers;      ///< (N) alternate location; ' ' for none
  std::vector<float> occupancies;    ///< (N)
  std::vector<std::uint32_t> lines;  ///< (N) line of the file
  /// What assemblies are made of, where that is not the author's chains: label_asym_id.
  std::vector<std::string> instances;
  std::vector<std::uint32_t> instance_of;  ///< (N) index into instances; empty: none are given

  std::size_t size() const { return structure.size(); }
};

/// What choose_atoms says of an atom that it leaves out.
inline constexpr std::uint32_t left_out = std::numeric_limits<std::uint32_t>::max();

/// Leaves one conformer of each residue: of the alternate locations that share an atom name, the
/// one with the highest mean occupancy, the first of the file on a tie (so that atoms of a residue
/// come from one conformer; two residue names at one position count as conformers, too). Leaves
/// out atoms that repeat name and position of another of their residue. Says each once.
/// Returns for each listed atom its index afterwards, or left_out. O(N log N).
std::vector<std::uint32_t> choose_atoms(AtomSites& sites, Remarks& remarks);

/// Warns of atoms at (9999.999, 9999.999, 9999.999), as some programs write for "not known".
void warn_of_placeholders(const AtomSites& sites, Remarks& remarks);

}  // namespace pliant
