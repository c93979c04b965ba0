// SPDX-License-Identifier: MIT
// What a structure contains and lacks, for `pliant info` and preparation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// A residue that lacks atoms, and their names.
struct IncompleteResidue {
  std::uint32_t residue;
  std::string atoms;  ///< "CG CD OE1 OE2"
};

/// Two consecutive residues of a chain that no bond joins.
struct ChainBreak {
  std::uint32_t before, after;
};

/// Counts and residue indices.
struct Survey {
  std::size_t amino_acids = 0, nucleotides = 0, waters = 0;
  std::size_t hydrogens = 0;
  std::vector<std::uint32_t> without_hydrogens;  ///< amino acids and nucleotides without any
  std::vector<std::uint32_t> modified;           ///< residues of a chain with an unknown name
  std::vector<std::uint32_t> ligands;  ///< residues of no known kind, with more than one atom
  std::vector<std::uint32_t> metals;   ///< residues that are a single metal atom
  std::vector<std::uint32_t> ions;     ///< residues that are a single other atom
  std::vector<IncompleteResidue> incomplete;  ///< side chains
  std::vector<ChainBreak> breaks;
  std::vector<Bond> disulphides;  ///< between two S
  bool is_backbone_only = false;  ///< there are amino acids, and none has a side chain
  bool is_ca_only = false;        ///< there are amino acids, and they have only CA
  bool has_confidence = false;    ///< B factors are pLDDT (confidence.hpp)
};

/// Surveys a structure whose bonds are known. Linear in the number of atoms.
Survey survey(const Structure& structure);

/// "A:LYS12", "LYS12" without a chain; "HEM" where the structure is a single residue.
std::string residue_label(const AtomTable& atoms, std::uint32_t residue);

/// "A:LYS12, A:GLU13 and 5 more".
std::string listed_residues(const AtomTable& atoms, const std::vector<std::uint32_t>& residues,
                            std::size_t most = 4);

/// Lists modified residues, ligands, metals, ions and disulphides, one line a kind: "ligands:
/// A:HEM301".
std::vector<std::string> found_parts(const Structure& structure, const Survey& survey);

/// Lists what is missing, one line each, except hydrogens, which preparation places.
std::vector<std::string> missing_parts(const Structure& structure, const Survey& survey);

/// Ligands with N or O and without any hydrogen.
std::vector<std::uint32_t> ligands_without_hydrogens(const AtomTable& atoms, const Survey& survey);

/// (R) mean B factor of each residue.
std::vector<double> residue_b_factors(const Structure& structure);

}  // namespace pliant
