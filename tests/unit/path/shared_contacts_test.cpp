// SPDX-License-Identifier: MIT
#include "pliant/path/shared_contacts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/molecule/made_structure.hpp"

namespace pliant::shared_contacts_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using namespace test;

constexpr auto bond = MolecularContactKind::hydrogen_bond;
constexpr auto tether = MolecularContactKind::hydrophobic;

/// ASP, LYS and an ion; `swapped` has the names of both O of ASP the other way round.
Structure salt(bool swapped, std::int64_t ion = 900) {
  Structure s;
  add_residue(s, "ASP", 1,
              {{swapped ? "OD2" : "OD1", "O", {}}, {swapped ? "OD1" : "OD2", "O", {2, 0, 0}}});
  add_residue(s, "LYS", 2, {{"NZ", "N", {3, 0, 0}}});
  add_residue(s, "ZN", ion, {{"ZN", "Zn", {5, 0, 0}}});
  return s;
}

MolecularContact contact(MolecularContactKind kind, std::uint32_t a, std::uint32_t b) {
  MolecularContact one;
  one.kind = kind;
  one.a = a;
  one.b = b;
  return one;
}

SharedContacts shared(const Structure& ours, const std::vector<MolecularContact>& our_contacts,
                      const Structure& theirs,
                      const std::vector<MolecularContact>& their_contacts) {
  const ResiduePairing all = with_ligands(ours, theirs, {{0, 1}, {0, 1}});
  const MatchedAtoms here(ours, all.ours), there(theirs, all.theirs);
  return share_contacts(our_contacts, here, their_contacts, there);
}

TEST(SharedContacts, AtomsThatAreAlikeAreOne) {
  const Structure ours = salt(false), theirs = salt(true);
  const auto found = shared(ours, {contact(bond, 2, 0)}, theirs, {contact(bond, 2, 0)});
  EXPECT_THAT(found.ours, SizeIs(1));
  EXPECT_THAT(found.theirs, SizeIs(1));
  EXPECT_THAT(found.only_ours, IsEmpty());
}

TEST(SharedContacts, JoinInEitherOrderButOfOneKind) {
  const Structure s = salt(false);
  EXPECT_THAT(shared(s, {contact(tether, 2, 0)}, s, {contact(tether, 0, 2)}).ours, SizeIs(1));
  const auto other = shared(s, {contact(tether, 2, 0)}, s, {contact(bond, 2, 0)});
  EXPECT_THAT(other.ours, IsEmpty());
  EXPECT_THAT(other.only_ours, SizeIs(1));
  EXPECT_THAT(other.only_theirs, SizeIs(1));
}

TEST(SharedContacts, ThoseOfWhatIsNotMatchedAreInNone) {
  const Structure ours = salt(false), theirs = salt(false, 901);
  const auto found = shared(ours, {contact(bond, 3, 0)}, theirs, {contact(bond, 3, 0)});
  EXPECT_THAT(found.ours, IsEmpty());
  EXPECT_THAT(found.only_ours, IsEmpty());
  EXPECT_THAT(found.only_theirs, IsEmpty());
}

TEST(SharedContacts, LigandsAreMatchedByChainNumberAndName) {
  const Structure s = salt(false);
  EXPECT_THAT(with_ligands(s, s, {{0, 1}, {0, 1}}).ours, ElementsAre(0, 1, 2));
  EXPECT_THAT(with_ligands(s, salt(false, 901), {{0, 1}, {0, 1}}).ours, ElementsAre(0, 1));
  EXPECT_THAT(shared(s, {contact(bond, 3, 0)}, s, {contact(bond, 3, 0)}).ours, SizeIs(1));
}

TEST(SharedContacts, OutsideIsHowFarADistanceIsFromItsInterval) {
  MolecularContact one = contact(tether, 0, 1);
  one.least = 1.0;
  one.most = 2.0;
  EXPECT_EQ(outside(one, std::vector<Vec3>{{}, {0.25, 0, 0}}), 0.75);
  EXPECT_EQ(outside(one, std::vector<Vec3>{{}, {1.5, 0, 0}}), 0.0);
  EXPECT_EQ(outside(one, std::vector<Vec3>{{}, {4.0, 0, 0}}), 2.0);
}

}  // namespace pliant::shared_contacts_test
