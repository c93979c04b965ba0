// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/tethers.hpp"

#include <gtest/gtest.h>

#include "unit/molecule/made_structure.hpp"

namespace pliant {
namespace tethers_test {

/// Lone carbons of residues 1, 2 and 3 of a chain, and a sulphur of another, on a line.
Structure on_a_line(double one, double two, double three) {
  Structure s;
  test::add_residue(s, "LIG", 1, {{"C1", "C", {0, 0, 0}}});
  test::add_residue(s, "LIG", 2, {{"C1", "C", {one, 0, 0}}});
  test::add_residue(s, "LIG", 3, {{"C1", "C", {one + two, 0, 0}}});
  test::add_residue(s, "LIG", 4, {{"S1", "S", {one + two + three, 0, 0}}}, "B");
  return s;
}

TEST(Tethers, JoinWhatIsNearInResiduesTwoApartOrOfTwoChains) {
  const auto found = hydrophobic_tethers(on_a_line(1.9, 1.9, 3.9));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].a, 0U);  // 3.8 Angstrom, below 1.7 + 1.7 + 0.5; the neighbours are nearer
  EXPECT_EQ(found[0].b, 2U);
  EXPECT_DOUBLE_EQ(found[0].distance, 3.8);
  EXPECT_DOUBLE_EQ(found[0].most, 3.8 + 0.5);
  EXPECT_EQ(found[0].energy, -1.0);
  EXPECT_EQ(found[1].a, 2U);  // 3.9, below 1.7 + 1.8 + 0.5
  EXPECT_EQ(found[1].b, 3U);
}

TEST(Tethers, ShortOnesAreHeldByTheSumOfRadii) {
  const auto found = hydrophobic_tethers(on_a_line(1.5, 1.5, 9.0));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_DOUBLE_EQ(found[0].most, 3.4 + 0.5);
  TetherOptions options;
  options.reach = -1.0;
  EXPECT_TRUE(hydrophobic_tethers(on_a_line(1.5, 1.5, 9.0), options).empty());
}

TEST(Tethers, APolarNeighbourForbidsThem) {
  Structure s = on_a_line(1.9, 1.9, 9.0);
  test::add_residue(s, "LIG", 5, {{"O1", "O", {0, 1.4, 0}}}, "C");
  s.bonds.push_back({0, 4, BondOrigin::file, 1});
  EXPECT_TRUE(hydrophobic_tethers(s).empty());
}

TEST(Metals, AreHeldBothWaysByWhatIsNear) {
  Structure s;
  test::add_residue(s, "ZN", 1, {{"ZN", "ZN", {0, 0, 0}}});
  test::add_residue(s, "LIG", 2,
                    {{"N1", "N", {2.1, 0, 0}},
                     {"O1", "O", {0, 2.79, 0}},
                     {"S1", "S", {0, 0, 2.81}},
                     {"C1", "C", {-2.31, 0, 0}}});
  const auto found = metal_contacts(s);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, MolecularContactKind::metal);
  EXPECT_EQ(found[0].b, 1U);
  EXPECT_DOUBLE_EQ(found[0].least, 1.9);
  EXPECT_DOUBLE_EQ(found[0].most, 2.3);
  EXPECT_EQ(found[1].b, 2U);
  s.bonds.push_back({0, 1, BondOrigin::file, 1});
  ASSERT_EQ(metal_contacts(s).size(), 1U);
  EXPECT_EQ(metal_contacts(s)[0].b, 2U);
}

TEST(Metals, HoldOtherResiduesAloneIfBondedInTheirs) {
  Structure s;
  test::add_residue(s, "HEM", 1,
                    {{"FE", "FE", {0, 0, 0}}, {"NA", "N", {2, 0, 0}}, {"O1", "O", {0, 2.7, 0}}});
  test::add_residue(s, "HIS", 2, {{"NE2", "N", {0, 0, 2.1}}});
  EXPECT_EQ(metal_contacts(s).size(), 3U);
  s.bonds.push_back({0, 1, BondOrigin::file, 1});
  ASSERT_EQ(metal_contacts(s).size(), 1U);
  EXPECT_EQ(metal_contacts(s)[0].b, 3U);
}

}  // namespace tethers_test
}  // namespace pliant
