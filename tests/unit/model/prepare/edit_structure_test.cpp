// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/edit_structure.hpp"

#include <gtest/gtest.h>

#include "unit/molecule/made_structure.hpp"

namespace pliant {
namespace edit_structure_test {

Structure water_and_glycine() {
  Structure s;
  test::add_residue(s, "HOH", 1, test::water({0, 9, 0}), "W");
  test::add_residue(s, "GLY", 1, test::glycine({0, 0, 0}));
  perceive_bonds(s);
  return s;
}

TEST(EditStructure, WithoutAtomsBondsAndResiduesFollow) {
  const EditedStructure edited =
      without_atoms(water_and_glycine(), {true, true, true, false, false, false, false});
  const Structure& s = edited.structure;
  EXPECT_EQ(edited.origin, (std::vector<std::uint32_t>{3, 4, 5, 6}));
  ASSERT_EQ(s.atoms.residues.size(), 1U);
  EXPECT_EQ(s.atoms.residues[0].name, "GLY");
  EXPECT_EQ(s.atoms.residue_of, (std::vector<std::uint32_t>{0, 0, 0, 0}));
  EXPECT_EQ(test::bond_texts(s),
            (std::vector<std::string>{"0-1 residue", "1-2 residue", "2-3 residue"}));
}

TEST(EditStructure, NewAtomsAreTheLastOfTheirResidue) {
  const Structure before = water_and_glycine();
  const EditedStructure edited =
      with_atoms(before, {{0, "X", 1, {1, 2, 3}}, {3, "H", 1, {0, 1, 0}}});
  const Structure& s = edited.structure;
  ASSERT_EQ(s.size(), before.size() + 2);
  EXPECT_EQ(s.atoms.names[3], "X");
  EXPECT_EQ(s.atoms.names.back(), "H");
  EXPECT_EQ(s.positions[3], (Vec3{1, 2, 3}));
  EXPECT_EQ(edited.origin[3], no_atom);
  EXPECT_EQ(edited.origin[4], 3U);
  EXPECT_EQ(s.bonds.size(), before.bonds.size() + 2);
  for (std::size_t k = 0; k < s.size(); ++k)
    EXPECT_EQ(s.atoms.serials[k], static_cast<std::int64_t>(k) + 1);
}

}  // namespace edit_structure_test
}  // namespace pliant
