// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/contact_list.hpp"

#include <gtest/gtest.h>

#include "unit/molecule/made_structure.hpp"

namespace pliant {
namespace contact_list_test {

/// D - H .. A - B on a line.
Structure line(double to_hydrogen) {
  return test::molecule({{"N", {0, 0, 0}},
                         {"H", {1, 0, 0}},
                         {"O", {1 + to_hydrogen, 0, 0}},
                         {"C", {2.2 + to_hydrogen, 0, 0}}});
}

MolecularContact bond() {
  MolecularContact contact{MolecularContactKind::hydrogen_bond, 0, 2, 1, 3};
  contact.energy = -2.0;
  return contact;
}

TEST(ContactList, AShortHydrogenBondMayGrowToTheUsualOne) {
  MolecularContact contact = bond();
  set_limits(contact, line(1.6));
  EXPECT_DOUBLE_EQ(contact.distance, 2.6);
  EXPECT_DOUBLE_EQ(contact.most, 3.1);
  EXPECT_DOUBLE_EQ(contact.hydrogen_most, 2.2);
  EXPECT_DOUBLE_EQ(contact.base_least, 2.2);
  EXPECT_DOUBLE_EQ(contact.base_most, 3.4);
}

TEST(ContactList, ALongOneMayGrowByItsSlack) {
  MolecularContact contact = bond();
  set_limits(contact, line(2.4));
  EXPECT_DOUBLE_EQ(contact.most, 3.6);
  EXPECT_DOUBLE_EQ(contact.hydrogen_most, 2.6);
}

TEST(ContactList, LimitsOfAContactAreOneGroup) {
  MolecularContact contact = bond();
  set_limits(contact, line(2.0));
  MolecularContact tether{MolecularContactKind::hydrophobic, 0, 3};
  tether.energy = -1.0;
  tether.most = 4.0;
  const auto limits = limits_of(std::vector{contact, tether});
  ASSERT_EQ(limits.size(), 4U);
  const Limit hydrogen{1, 2, 0.0, contact.hydrogen_most, LimitKind::hydrogen_bond, -2 * kj_per_kcal,
                       0};
  EXPECT_EQ(limits[0], hydrogen);
  EXPECT_EQ(limits[2].least, contact.base_least);
  const Limit held{0, 3, 0.0, 4.0, LimitKind::hydrophobic, -kj_per_kcal, 1};
  EXPECT_EQ(limits[3], held);
}

TEST(ContactList, SaltBridgesAreSortedAmongHydrogenBonds) {
  using Kind = MolecularContactKind;
  std::vector<MolecularContact> all{{Kind::metal, 0, 1},
                                    {Kind::hydrophobic, 0, 1},
                                    {Kind::hydrogen_bond, 5, 6},
                                    {Kind::salt_bridge, 4, 6},
                                    {Kind::hydrogen_bond, 3, 9}};
  sort(all);
  std::vector<std::uint32_t> order;
  for (const MolecularContact& contact : all) order.push_back(contact.a);
  EXPECT_EQ(order, (std::vector<std::uint32_t>{3, 4, 5, 0, 0}));
  EXPECT_EQ(all.back().kind, Kind::metal);
}

}  // namespace contact_list_test
}  // namespace pliant
