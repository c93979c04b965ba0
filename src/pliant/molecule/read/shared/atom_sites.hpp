// SPDX-License-Identifier: MIT
// The atoms listed in a macromolecular file, before one conformer of each residue is chosen.
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
  Structure structure;           ///< atoms, positions, charges; residues are runs of one name
  std::vector<char> conformers;  ///< (N) alternate location; ' ' for none
  std::vector<std::string_view> altlocs;  ///< labels of several characters; the k-th is character k
  std::vector<float> occupancies;         ///< (N)
  std::vector<std::uint32_t> lines;       ///< (N) line of the file
  /// Chains of assemblies where those are not the author's: label_asym_id.
  std::vector<std::string> instances;
  std::vector<std::uint32_t> instance_of;  ///< (N) index into instances; empty: none are given

  std::vector<std::string_view> segments;  ///< (R) segment, or label_asym_id; "" for none
  std::vector<std::uint32_t> sections;     ///< (R) parts of the file that no chain crosses
  std::vector<char> unnumbered;            ///< (R) not 0: the file gives no number
  std::uint32_t ended_sections = 0;        ///< sections whose end the file states; 0: none

  std::size_t size() const { return structure.size(); }
};

/// Index that choose_atoms returns for an atom that it leaves out.
inline constexpr std::uint32_t left_out = std::numeric_limits<std::uint32_t>::max();

/// Gathers the atoms of each residue, which can stand apart in a file, and those of chains
/// (order_residues), sets chain ends, and keeps one conformer of each residue: of the alternate
/// locations that share an atom name, the one with the highest mean occupancy, or the first of the
/// file on a tie (so that the atoms of a residue come from one conformer; two residue names at one
/// position count as conformers, too). Leaves out the dummy atoms of a membrane, and atoms that
/// repeat name and position of another atom of their residue. Reports each kind
/// once, and where the order is no longer that of the file. Returns the new index of each listed
/// atom, or left_out. O(N log N).
std::vector<std::uint32_t> choose_atoms(AtomSites& sites, Remarks& remarks);

/// Warns of atoms at (9999.999, 9999.999, 9999.999), which some programs write for "not known".
void warn_of_placeholders(const AtomSites& sites, Remarks& remarks);

}  // namespace pliant
