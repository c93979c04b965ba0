// SPDX-License-Identifier: MIT
// Trace: the residues of a polymer, each represented by one atom: the alpha carbon of amino acids,
// P of nucleotides.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/framework/atom_table.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

enum class PolymerKind : std::uint8_t { amino, nucleic };

/// "CA" or "P": the atom that represents a residue of that kind.
std::string_view trace_atom(PolymerKind kind);

/// One residue of a trace.
struct TracedResidue {
  std::uint32_t atom = 0;  ///< that represents it
  Residue residue;
  PolymerKind kind = PolymerKind::amino;
  char letter = 'X';  ///< X for an unknown name
};

/// R residues in the order of the file.
class Trace {
 public:
  Trace() = default;

  /// Adds a residue. A residue with P is left out unless it is a known nucleotide, since others can
  /// be phosphates.
  void add(std::uint32_t atom, Residue residue, PolymerKind kind);

  std::size_t size() const { return residues_.size(); }
  const TracedResidue& operator[](std::size_t residue) const { return residues_[residue]; }
  const std::vector<TracedResidue>& residues() const { return residues_; }

  /// "A:LYS12", or "LYS12" where the file names no chain.
  std::string label(std::size_t residue) const;
  /// "A:1-3, A:74-76": rising residues, consecutive ones as a range.
  std::string ranges(std::span<const std::uint32_t> residues) const;

 private:
  std::vector<TracedResidue> residues_;
};

/// The trace of a structure: each carbon called CA and each phosphorus called P.
Trace trace_of(const Structure& structure);

}  // namespace pliant
