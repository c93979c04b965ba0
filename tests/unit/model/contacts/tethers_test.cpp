// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "pliant/model/contacts/contact_list.hpp"
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
  const auto found = find_tethers(on_a_line(1.9, 1.9, 3.9), {});
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
  const auto found = find_tethers(on_a_line(1.5, 1.5, 9.0), {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_DOUBLE_EQ(found[0].most, 3.4 + 0.5);
  const ContactOptions options{.tethers = {.reach = -1.0}};
  EXPECT_TRUE(find_tethers(on_a_line(1.5, 1.5, 9.0), options).empty());
}

TEST(Tethers, APolarNeighbourForbidsThem) {
  Structure s = on_a_line(1.9, 1.9, 9.0);
  test::add_residue(s, "LIG", 5, {{"O1", "O", {0, 1.4, 0}}}, "C");
  s.bonds.push_back({0, 4, BondOrigin::file, 1});
  EXPECT_TRUE(find_tethers(s, {}).empty());
}

}  // namespace tethers_test
}  // namespace pliant
