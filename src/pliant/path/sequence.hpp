// SPDX-License-Identifier: MIT
// Sequences of residues as letters, and which residue of one is which of another (alignment).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace pliant {

/// One row of a table of residues: what a file calls it, and its letter.
struct ResidueLetter {
  std::string_view name;
  char letter;
};

/// Amino acids, with the names of force fields and of what stands for them in crystals.
std::span<const ResidueLetter> amino_acid_letters();

/// Nucleotides of RNA and DNA.
std::span<const ResidueLetter> nucleotide_letters();

inline constexpr char unknown_letter = 'X';

/// The letter of a name in one of the tables; unknown_letter where it is not there.
char letter_of(std::string_view name, std::span<const ResidueLetter> table);

using ResiduePair = std::array<std::uint32_t, 2>;  ///< a residue of ours, one of theirs

/// Residues of two sequences that go together, rising: global alignment (Needleman and Wunsch, J.
/// Mol. Biol. 48 (1970) 443) with match 2, mismatch -1, gap -2; of equal ways a pair goes before a
/// gap in theirs, and that before a gap in ours. Time and memory as the product of the lengths.
std::vector<ResiduePair> align(std::string_view ours, std::string_view theirs);

}  // namespace pliant
