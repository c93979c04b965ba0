// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/side_chain_geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/edit_structure.hpp"
#include "pliant/model/prepare/side_chain.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"
#include "support/source_folder.hpp"

namespace pliant {
namespace side_chain_geometry_test {

constexpr const char* amino_acids[] = {"ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU",
                                       "GLY", "HIS", "ILE", "LEU", "LYS", "MET", "PHE",
                                       "PRO", "SER", "THR", "TRP", "TYR", "VAL"};

std::set<std::string> words(std::string_view text) {
  std::istringstream in{std::string(text)};
  return {std::istream_iterator<std::string>(in), {}};
}

TEST(SideChainGeometry, EveryAtomButCbHasARow) {
  for (const char* residue : amino_acids) {
    std::set<std::string> expected = words(side_chain_atoms(residue)), found;
    expected.erase("CB");
    for (const SideChainAtom& row : side_chain_geometry(residue)) found.emplace(row.name);
    EXPECT_EQ(found, expected) << residue;
  }
  EXPECT_TRUE(side_chain_geometry("LIG").empty());
}

TEST(SideChainGeometry, RowsAreAfterTheAtomsThatTheyArePlacedBy) {
  for (const char* residue : amino_acids) {
    std::set<std::string_view> known{"N", "CA", "C", "CB"};
    int turns = 0;
    for (const SideChainAtom& row : side_chain_geometry(residue)) {
      for (std::string_view needed : {row.reference, row.neighbour, row.parent})
        EXPECT_TRUE(known.contains(needed)) << residue << " " << row.name << " " << needed;
      known.insert(row.name);
      EXPECT_GT(row.length, 1.2);
      EXPECT_LT(row.length, 1.9);
      EXPECT_GT(row.angle, 100.0);
      EXPECT_LT(row.angle, 135.0);
      turns = std::max<int>(turns, row.chi);
    }
    EXPECT_EQ(usual_turns(residue).empty(), turns == 0) << residue;
  }
}

/// CB of a file, which is left out, comes back near where it was, and on the side of L amino acids.
TEST(SideChainGeometry, CbLiesWhereLAminoAcidsHaveIt) {
  Structure file = read_structure(molecule_file("peptide_20.pdb"));
  const ResidueAtoms residues(file.atoms);
  for (std::size_t r = 0; r < file.atoms.residues.size(); ++r) {
    const std::uint32_t cb = residues.find(r, "CB");
    if (cb == no_atom) continue;
    const auto at = [&](const char* name) { return file.positions[residues.find(r, name)]; };
    const Vec3 ideal = ideal_cb(at("N"), at("CA"), at("C"));
    EXPECT_LT(distance(ideal, file.positions[cb]), 0.3) << file.atoms.residues[r].name;
    EXPECT_NEAR(distance(ideal, at("CA")), 1.53, 0.02);
  }
}

/// Side chains are built to CB, and then to their ends, with the lengths of their rows.
TEST(SideChain, AtomsThatAreMissingGetTheLengthsOfTheirRows) {
  Structure file = read_structure(molecule_file("peptide_20.pdb"));
  perceive_bonds(file);
  std::vector<bool> is_out;
  for (std::size_t k = 0; k < file.size(); ++k) {
    const std::string& name = file.atoms.names[k];
    is_out.push_back(file.atoms.elements[k] == 1 || !words("N CA C O OXT CB").contains(name));
  }
  const Structure bare = without_atoms(file, is_out).structure;
  const ResidueAtoms residues(bare.atoms);
  for (std::uint32_t r = 0; r < bare.atoms.residues.size(); ++r) {
    SideChain chain(bare, residues, r);
    SCOPED_TRACE(bare.atoms.residues[r].name);
    EXPECT_TRUE(chain.can_be_built());
    const auto missing = chain.missing();
    if (missing.empty()) continue;
    const auto placed = chain.placed(chain.turns().empty() ? SideChainTurns{} : chain.turns()[0]);
    ASSERT_EQ(placed.size(), missing.size());
    for (const SideChainAtom& row : chain.rows()) {
      const auto place_of = [&](std::string_view name) {
        const auto at = std::find(missing.begin(), missing.end(), name);
        return at == missing.end()
                   ? bare.positions[residues.find(r, name)]
                   : placed[static_cast<std::size_t>(at - missing.begin())].position;
      };
      EXPECT_NEAR(distance(place_of(row.name), place_of(row.parent)), row.length,
                  chain.is_proline() ? 0.2 : 1e-9)
          << row.name;
    }
  }
}

}  // namespace side_chain_geometry_test
}  // namespace pliant
