// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/contact_list.hpp"

#include "pliant/base/choices.hpp"
#include "pliant/model/contacts/contact_file.hpp"
#include "pliant/model/contacts/contact_kinds.hpp"
#include "pliant/model/model.hpp"
#include "pliant/model/rigidity/rigidity_network.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::contact_list_test {

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

/// Four atoms on a line, no two of which are bonded, and a contact of the first two of that kind.
Structure four_atoms() {
  return test::molecule({{"N", {0, 0, 0}}, {"O", {3, 0, 0}}, {"H", {1, 0, 0}}, {"C", {4, 0, 0}}});
}

MolecularContact contact_of(const MolecularContactKindEntry& row) {
  MolecularContact contact{row.kind, 0, 1};
  if (row.has_hydrogen()) std::tie(contact.hydrogen, contact.base) = std::pair(2U, 3U);
  contact.energy = -1.5;
  set_limits(contact, four_atoms());
  return contact;
}

TEST(ContactKinds, EachIsReadBackFromAFile) {
  for (const MolecularContactKindEntry& row : molecular_contact_kinds()) {
    const std::vector<MolecularContact> contacts{contact_of(row)};
    const Structure s = four_atoms();
    EXPECT_EQ(parse_contacts({"c.csv", contacts_as_csv(contacts, s)}, s), contacts) << row.name;
    EXPECT_EQ(parse_contacts({"c.json", contacts_as_json(contacts, s)}, s), contacts) << row.name;
  }
}

TEST(ContactKinds, EachHasItsSlackInALimitThatFilesName) {
  for (const MolecularContactKindEntry& row : molecular_contact_kinds()) {
    const auto limits = limits_of(std::vector{contact_of(row)});
    ASSERT_EQ(limits.size(), row.has_hydrogen() ? 3U : 1U) << row.name;
    EXPECT_DOUBLE_EQ(limits[row.has_hydrogen() ? 1 : 0].most, 3.0 + row.slack) << row.name;
    EXPECT_EQ(find_limit_kind(name(limits[0].kind)), row.limit) << row.name;
  }
}

TEST(ContactKinds, EachHasItsBarsInThePebbleGame) {
  for (const MolecularContactKindEntry& row : molecular_contact_kinds()) {
    const auto network = rigidity_network(four_atoms(), std::vector{contact_of(row)});
    ASSERT_EQ(network.edges.size(), 1U) << row.name;
    EXPECT_EQ(network.edges[0].bars, row.bars) << row.name;
    EXPECT_EQ(network.first_hydrogen_bond, row.has_hydrogen() ? 0U : 1U) << row.name;
  }
}

/// Notes of a model name each usual kind, and another where it is asked for.
TEST(ContactKinds, ThoseThatAreNotUsualAreFoundWhereTheyAreAskedFor) {
  for (const MolecularContactKindEntry& row : molecular_contact_kinds()) {
    const std::string shown = std::string(row.name) + " 0";
    const auto is_told = [&](const ModelOptions& options) {
      const MolecularModel model = build_model(four_atoms(), options);
      return std::any_of(model.notes.begin(), model.notes.end(),
                         [&](const auto& line) { return line.find(shown) != line.npos; });
    };
    EXPECT_EQ(is_told({}), row.is_usual) << row.name;
    EXPECT_TRUE(is_told({.more_contacts = {std::string(row.name)}})) << row.name;
  }
}

TEST(ContactKinds, AnUnknownOneIsRefusedWithThoseThatAreThere) {
  EXPECT_ERROR(OptionError,
               unknown_choice("kind of contact", "cation_pie", names_of(molecular_contact_kinds())),
               find_contacts(four_atoms(), {.more_contacts = {"cation_pie"}}));
  EXPECT_ERROR(OptionError, "more_contacts: goes with contacts that are found, not with given ones",
               build_model(four_atoms(), {.more_contacts = {"cation_pi"},
                                          .contacts = std::vector<MolecularContact>{}}));
}

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

}  // namespace pliant::contact_list_test
