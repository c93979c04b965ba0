// SPDX-License-Identifier: MIT
// Hydrogen bonds that ligands give whose hydrogens the file lacks: the geometry is made up, so that
// the hydrogen would point straight at the oxygen of glycine.
#include "pliant/model/contacts/bare_donors.hpp"

#include "pliant/model/contacts/hydrogen_bonds.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::bare_donors_test {

const Vec3 carbon{2.0, 1.42, 0.0}, oxygen{1.3, 2.42, 0.0};  // of glycine
const Vec3 along = (1.0 / distance(carbon, oxygen)) * (oxygen - carbon), across{0, 0, 1};

/// Where an atom is that is `length` from `from`, at an angle (cosine) to the way back to glycine.
Vec3 beside(Vec3 from, double length, double cosine, double side = 1.0) {
  return from + length * (-cosine * along + side * std::sqrt(1.0 - cosine * cosine) * across);
}

/// Glycine and a ligand.
Structure complex(const std::vector<test::MadeAtom>& ligand) {
  Structure s;
  test::add_residue(s, "GLY", 1, test::glycine({0, 0, 0}));
  test::add_residue(s, "LIG", 2, ligand);
  perceive_bonds(s);
  return s;
}

constexpr double tetrahedral = -0.33380685923377096;
const Vec3 donor = oxygen + 2.8 * along;

std::vector<MolecularContact> with_one_neighbour(const char* element, double length,
                                                 double cosine = tetrahedral) {
  return hydrogen_bonds(
      complex({{"X1", element, donor}, {"C1", "C", beside(donor, length, cosine)}}));
}

TEST(BareDonors, AHydroxylGivesOneStraightBond) {
  const auto found = with_one_neighbour("O", 1.42);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, MolecularContactKind::hydrogen_bond);
  EXPECT_EQ(found[0].a, 4U);
  EXPECT_EQ(found[0].b, 3U);
  EXPECT_EQ(found[0].hydrogen, MolecularContact::none);
  EXPECT_NEAR(found[0].energy, -8.0, 1e-6);
  EXPECT_EQ(limits_of(found).size(), 1U);
}

TEST(BareDonors, DoubleBondsAndNitrilesGiveNone) {
  EXPECT_TRUE(with_one_neighbour("O", 1.25).empty());
  EXPECT_TRUE(with_one_neighbour("N", 1.15).empty());
  EXPECT_EQ(with_one_neighbour("N", 1.33, -0.5).size(), 1U);
}

TEST(BareDonors, TheirHydrogenKeepsItsAngle) {
  EXPECT_EQ(with_one_neighbour("O", 1.42, -0.7).size(), 1U);
  EXPECT_TRUE(with_one_neighbour("O", 1.42, -1.0).empty());  // it would be 70 degrees off
}

TEST(BareDonors, ALigandThatHasHydrogensIsTakenAsItIs) {
  const Vec3 c = beside(donor, 1.42, tetrahedral);
  EXPECT_TRUE(
      hydrogen_bonds(complex({{"O1", "O", donor}, {"C1", "C", c}, {"H1", "H", c + 1.09 * across}}))
          .empty());
}

TEST(BareDonors, NitrogenInARingGivesOrTakesByWhatIsThere) {
  const std::vector<test::MadeAtom> ligand{{"N1", "N", donor},
                                           {"C1", "C", beside(donor, 1.35, -0.5, 1.0)},
                                           {"C2", "C", beside(donor, 1.35, -0.5, -1.0)}};
  EXPECT_EQ(hydrogen_bonds(complex(ligand)).size(), 1U);
  Structure s;
  test::add_residue(s, "SER", 1, {{"OG", "O", oxygen}, {"HG", "H", oxygen + 0.96 * along}});
  test::add_residue(s, "LIG", 2, ligand);
  perceive_bonds(s);
  const auto found = hydrogen_bonds(s);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].hydrogen, 1U);
  EXPECT_EQ(found[0].b, 2U);
}

}  // namespace pliant::bare_donors_test
