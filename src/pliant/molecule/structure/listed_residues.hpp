// SPDX-License-Identifier: MIT
// Atoms as a file lists them, in any order.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/framework/atom_table.hpp"

namespace pliant {

/// N atoms in R runs: neighbours that agree in all that names a residue. Spans are empty where
/// nothing is known.
struct ListedResidues {
  const AtomTable& atoms;  ///< the residues of the table are the runs
  std::span<const Vec3> positions;
  std::span<const char> conformers;            ///< (N) alternate locations
  std::span<const std::string_view> segments;  ///< (R) what names a chain besides its name
  std::span<const std::uint32_t> sections;     ///< (R) parts of the list that no chain crosses
  std::span<const char> unnumbered;            ///< (R) not 0: the file has no number

  std::string_view segment(std::size_t run) const {
    return segments.empty() ? std::string_view() : segments[run];
  }
  std::uint32_t section(std::size_t run) const { return sections.empty() ? 0 : sections[run]; }
  char conformer(std::size_t atom) const { return conformers.empty() ? ' ' : conformers[atom]; }
  const Residue& residue(std::size_t atom) const { return atoms.residues[atoms.residue_of[atom]]; }
};

}  // namespace pliant
