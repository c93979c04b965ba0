// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "pliant/model/contacts/contact_list.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant {
namespace cation_pi_test {

/// A ring of phenylalanine about the origin in the plane z = 0, CG at x = 1.39.
Structure ring() {
  Structure s;
  const double r = 1.39, x = 0.695, y = 1.2038;
  test::add_residue(s, "PHE", 1,
                    {{"CG", "C", {r, 0, 0}},
                     {"CD1", "C", {x, y, 0}},
                     {"CE1", "C", {-x, y, 0}},
                     {"CZ", "C", {-r, 0, 0}},
                     {"CE2", "C", {-x, -y, 0}},
                     {"CD2", "C", {x, -y, 0}}});
  return s;
}

/// Besides, the end of a side chain of lysine with NZ at a place, and so many hydrogens.
Structure with_lysine(Vec3 at, std::uint32_t hydrogens = 3) {
  Structure s = ring();
  test::add_residue(s, "LYS", 5, {{"CE", "C", at + Vec3{0, 0, 1.5}}, {"NZ", "N", at}});
  s.bonds.push_back({6, 7, BondOrigin::file, 1});
  for (std::uint32_t k = 0; k < hydrogens; ++k) {
    s.atoms.names.push_back("HZ" + std::to_string(k + 1));
    s.atoms.elements.push_back(1);
    s.atoms.residue_of.push_back(1);
    s.atoms.serials.push_back(9 + k);
    s.positions.push_back(at + Vec3{1.0, double(k), 0});
    s.bonds.push_back({7, 8 + k, BondOrigin::file, 1});
  }
  return s;
}

std::size_t count(const Structure& s) { return find_cation_pi(s, {}).size(); }

TEST(CationPi, AChargeOverTheFaceIsHeldToTheNearestAtomOfTheRing) {
  const auto found = find_cation_pi(with_lysine({-1.0, 0, 4.0}), {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, MolecularContactKind::cation_pi);
  EXPECT_EQ(found[0].a, 7U);
  EXPECT_EQ(found[0].b, 3U);  // CZ
  EXPECT_DOUBLE_EQ(found[0].distance, std::hypot(0.39, 4.0));
  EXPECT_DOUBLE_EQ(found[0].most, found[0].distance + 0.5);
  EXPECT_EQ(found[0].least, 0.0);
  EXPECT_EQ(found[0].energy, -2.0);
}

TEST(CationPi, IsWithin6OfTheCentreAndWithin2OfTheAxis) {
  EXPECT_EQ(count(with_lysine({0, 0, 5.99})), 1U);
  EXPECT_EQ(count(with_lysine({0, 0, -5.99})), 1U);
  EXPECT_EQ(count(with_lysine({0, 0, 6.01})), 0U);
  EXPECT_EQ(count(with_lysine({0, 1.99, 4.0})), 1U);
  EXPECT_EQ(count(with_lysine({0, 2.01, 4.0})), 0U);
  EXPECT_EQ(count(with_lysine({5.0, 0, 0})), 0U);  // in the plane
}

TEST(CationPi, AnAmineWithoutItsThirdHydrogenHasNoCharge) {
  EXPECT_EQ(count(with_lysine({0, 0, 4.0}, 2)), 0U);
}

TEST(CationPi, ARingThatLacksAnAtomIsNone) {
  Structure s = with_lysine({0, 0, 4.0});
  s.atoms.names[2] = "X";
  EXPECT_EQ(count(s), 0U);
}

/// Tryptophan has two; the benzene's centre is at the origin, the pyrrole's near (2.1, 0.7, 0).
TEST(CationPi, OfTwoRingsInAResidueTheNearerCounts) {
  Structure s;
  test::add_residue(s, "TRP", 1,
                    {{"CD2", "C", {1.21, -0.7, 0}},
                     {"CE2", "C", {1.21, 0.7, 0}},
                     {"CZ2", "C", {0, 1.4, 0}},
                     {"CH2", "C", {-1.21, 0.7, 0}},
                     {"CZ3", "C", {-1.21, -0.7, 0}},
                     {"CE3", "C", {0, -1.4, 0}},
                     {"NE1", "N", {2.55, 1.1, 0}},
                     {"CD1", "C", {3.4, 0, 0}},
                     {"CG", "C", {2.55, -1.1, 0}}});
  test::add_residue(s, "ARG", 4, {{"CZ", "C", {1.3, 0.1, 3.5}}});
  const auto found = find_cation_pi(s, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(s.atoms.names[found[0].b], "CE2");  // both rings have it; the pyrrole is nearer
  s.positions.back() = {2.4, 0.1, 3.5};
  ASSERT_EQ(count(s), 1U);
  EXPECT_EQ(s.atoms.names[find_cation_pi(s, {})[0].b], "CD1");
}

}  // namespace cation_pi_test
}  // namespace pliant
