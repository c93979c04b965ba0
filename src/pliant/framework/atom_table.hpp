// SPDX-License-Identifier: MIT
// Atom table: names of joints, for messages and trajectory files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pliant {

/// One residue of a macromolecule, or the whole of a small molecule.
struct Residue {
  std::string name;           ///< "LYS"; "UNK" if a molecule file gives none; "" in a graph
  std::int64_t number = 1;    ///< author's number; may be negative
  char insertion_code = ' ';  ///< ' ' for none
  std::string chain;          ///< author's chain name; "" for none

  friend bool operator==(const Residue&, const Residue&) = default;
};

/// Column-wise table of N atoms; atoms of a residue are consecutive.
struct AtomTable {
  std::vector<std::string> names;         ///< (N) "CA", "C1"
  std::vector<std::uint8_t> elements;     ///< (N) atomic number; 0 unknown or dummy
  std::vector<std::uint32_t> residue_of;  ///< (N) index into residues
  std::vector<Residue> residues;
  std::vector<std::int64_t> serials;  ///< (N) the number the file gives, or 1..N

  std::size_t size() const { return names.size(); }

  /// "A:LYS12:CA", or "LYS12:CA" without a chain; "C1(4)" (name and serial) where the molecule is a
  /// single residue, "a" if that residue has no name. Control and non-ASCII bytes are escaped as
  /// \xNN.
  std::string label(std::size_t atom) const;
};

/// Throws InputError unless all columns have the same length and each atom has a residue.
void check(const AtomTable& atoms);

}  // namespace pliant
