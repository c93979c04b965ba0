// SPDX-License-Identifier: MIT
// Residue templates: the bonds of amino acids, nucleotides, caps and water, by atom names.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "pliant/framework/atom_table.hpp"

namespace pliant {

enum class ResidueKind : std::uint8_t { amino_acid, cap, nucleotide, water };

/// An atom name in one spelling, at most eight characters, packed so that names can be compared in
/// one instruction; 0 for an empty or a longer name.
using AtomKey = std::uint64_t;

/// The key of an atom name: "1HB" is "HB1", "C1*" is "C1'"; if `is_hydrogen`, deuterium's "DB1" is
/// "HB1".
AtomKey atom_key(std::string_view name, bool is_hydrogen);

/// What a residue's name implies. Atoms are numbered by their index in `names`.
struct ResidueTemplate {
  struct Edge {
    std::uint8_t a, b;
    std::uint8_t order;  ///< 1, 2, 3; 4 aromatic
  };
  ResidueKind kind = ResidueKind::amino_acid;
  std::vector<AtomKey> names;  ///< sorted; all spellings in use, so that some exclude each other
  std::vector<Edge> edges;

  static constexpr int none = -1;
  /// The number of the atom called `key`, or `none`.
  int find(AtomKey key) const;
};

/// The template of a residue name: standard, protonation variant or terminal form of a force
/// field ("HIP", "CYX", "NALA", "DA5"); null where there is none. Upper case only.
const ResidueTemplate* find_residue_template(std::string_view name);

/// Whether a residue is no molecule but draws a membrane: DUM of OPM and of the PDB.
bool is_membrane_dummy(const Residue& residue);

/// Every residue name with a template, sorted.
std::vector<std::string_view> residue_template_names();

}  // namespace pliant
