// SPDX-License-Identifier: MIT
// Atoms, their neighbours, their residues' nodes, and words for them.
#include "pliant/model/atoms/atom_graph.hpp"

#include <gtest/gtest.h>

#include "pliant/base/error.hpp"
#include "pliant/model/atoms/atom_words.hpp"
#include "pliant/model/atoms/near_atoms.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"
#include "support/error_text.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant {
namespace atom_graph_test {

using Atoms = std::vector<std::uint32_t>;

/// O H H of a water, then N CA C O of a glycine, then a ligand C1 H1.
Structure mixed() {
  Structure s;
  test::add_residue(s, "HOH", 1, test::water({0, 9, 0}), "W");
  test::add_residue(s, "GLY", 2, test::glycine({0, 0, 0}));
  test::add_residue(s, "LIG", 3, {{"C1", "C", {9, 0, 0}}, {"H1", "H", {10, 0, 0}}}, "L");
  perceive_bonds(s);
  return s;
}

TEST(AtomGraph, KnowsHydrogensAndHeavyNeighbours) {
  const Structure s = mixed();
  const AtomGraph graph(s);
  EXPECT_EQ(graph.hydrogens_at(0), 2U);
  EXPECT_EQ(graph.first_heavy(1), 0U);
  EXPECT_EQ(graph.heavy_at(5), (Atoms{4, 6}));
  EXPECT_EQ(graph.first_heavy(5, 4), 6U);
  EXPECT_EQ(graph.first_heavy(0), no_atom);
  EXPECT_TRUE(graph.are_within_two_bonds(3, 5));
  EXPECT_FALSE(graph.are_bonded(3, 5));
  EXPECT_FALSE(graph.are_within_two_bonds(3, 6));
}

TEST(ResidueAtoms, AreFoundByName) {
  const Structure s = mixed();
  const ResidueAtoms residues(s.atoms);
  EXPECT_EQ(residues.begin(1), 3U);
  EXPECT_EQ(residues.end(1), 7U);
  EXPECT_EQ(residues.find(1, "CA"), 4U);
  EXPECT_EQ(residues.find(1, "CB"), no_atom);
}

TEST(NearAtoms, AreThoseWithinReachButNotItself) {
  const Structure s = mixed();
  const auto near = near_atoms(s, Atoms{4, 7}, Atoms{3, 4, 5, 6, 8}, 1.6);
  EXPECT_EQ(Atoms(near.at(0).begin(), near.at(0).end()), (Atoms{3, 5}));
  EXPECT_EQ(Atoms(near.at(1).begin(), near.at(1).end()), (Atoms{8}));
}

TEST(ResidueNodes, AreAlphaCarbonsAndHeavyAtomsOfTheRest) {
  Structure s = mixed();  // one amino acid alone would be a small molecule
  test::add_residue(s, "ALA", 4, {{"N", "N", {30, 0, 0}}, {"CA", "C", {31, 0, 0}}}, "A");
  const ResidueNodes nodes = residue_nodes(s);
  EXPECT_EQ(nodes.atom, (Atoms{0, 4, 7, 10}));
  EXPECT_EQ(nodes.is_residue, (std::vector<bool>{false, true, false, true}));
  EXPECT_EQ(nodes.of_atom, (Atoms{0, 0, 0, 1, 1, 1, 1, 2, 2, 3, 3}));
}

TEST(AtomWords, AreLabelsWhereOneAtomHasIt) {
  Structure s = mixed();
  test::add_residue(s, "LIG", 3, {{"C1", "C", {19, 0, 0}}}, "L");
  const AtomWords words(s.atoms);
  EXPECT_EQ(words.word_for(4), "A:GLY2:CA");
  EXPECT_EQ(words.word_for(7), "7");  // two atoms are L:LIG3:C1
  EXPECT_EQ(words.find("A:GLY2:CA", {"x", 1}), 4U);
  EXPECT_EQ(words.find("7", {"x", 1}), 7U);
  EXPECT_TRUE(test::error_text<InputError>([&] {
                words.find("L:LIG3:C1", {"x.csv", 4});
              }).starts_with("x.csv:4: "));
  EXPECT_TRUE(test::error_text<InputError>([&] {
                words.find("Q", {"x.csv", 5});
              }).starts_with("x.csv:5: "));
}

}  // namespace atom_graph_test
}  // namespace pliant
