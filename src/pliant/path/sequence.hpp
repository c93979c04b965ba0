// SPDX-License-Identifier: MIT
// Sequences of residues as letters, and their alignment.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace pliant {

/// A row of a table of residues: a name in files, and its letter.
struct ResidueLetter {
  std::string_view name;
  char letter;
};

/// Amino acids, with the names of force fields and of modified residues in crystals.
std::span<const ResidueLetter> amino_acid_letters();

/// Nucleotides of RNA and DNA.
std::span<const ResidueLetter> nucleotide_letters();

inline constexpr char unknown_letter = 'X';

/// The letter of a name in a table; unknown_letter if it is not there.
char letter_of(std::string_view name, std::span<const ResidueLetter> table);

using ResiduePair = std::array<std::uint32_t, 2>;  ///< a residue of ours, one of theirs

/// Matched residues of two sequences, rising: global alignment (Needleman and Wunsch, J. Mol. Biol.
/// 48 (1970) 443) with match 2, mismatch -1, gap -2. Among equal alignments a pair is preferred to
/// a gap in theirs, and that to a gap in ours. Time and memory are proportional to the product of
/// the lengths.
std::vector<ResiduePair> align(std::string_view ours, std::string_view theirs);

}  // namespace pliant
