// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "pliant/model/contacts/contact_list.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant {
namespace metals_test {

TEST(Metals, AreHeldBothWaysByWhatIsNear) {
  Structure s;
  test::add_residue(s, "ZN", 1, {{"ZN", "ZN", {0, 0, 0}}});
  test::add_residue(s, "LIG", 2,
                    {{"N1", "N", {2.1, 0, 0}},
                     {"O1", "O", {0, 2.79, 0}},
                     {"S1", "S", {0, 0, 2.81}},
                     {"C1", "C", {-2.31, 0, 0}}});
  const auto found = find_metals(s, {});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].kind, MolecularContactKind::metal);
  EXPECT_EQ(found[0].b, 1U);
  EXPECT_DOUBLE_EQ(found[0].least, 1.9);
  EXPECT_DOUBLE_EQ(found[0].most, 2.3);
  EXPECT_EQ(found[1].b, 2U);
  s.bonds.push_back({0, 1, BondOrigin::file, 1});
  ASSERT_EQ(find_metals(s, {}).size(), 1U);
  EXPECT_EQ(find_metals(s, {})[0].b, 2U);
}

TEST(Metals, HoldOtherResiduesAloneIfBondedInTheirs) {
  Structure s;
  test::add_residue(s, "HEM", 1,
                    {{"FE", "FE", {0, 0, 0}}, {"NA", "N", {2, 0, 0}}, {"O1", "O", {0, 2.7, 0}}});
  test::add_residue(s, "HIS", 2, {{"NE2", "N", {0, 0, 2.1}}});
  EXPECT_EQ(find_metals(s, {}).size(), 3U);
  s.bonds.push_back({0, 1, BondOrigin::file, 1});
  ASSERT_EQ(find_metals(s, {}).size(), 1U);
  EXPECT_EQ(find_metals(s, {})[0].b, 3U);
}

}  // namespace metals_test
}  // namespace pliant
