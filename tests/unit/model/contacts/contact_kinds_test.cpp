// SPDX-License-Identifier: MIT
// Whatever the table of kinds of contacts has a row for works everywhere.
#include "pliant/model/contacts/contact_kinds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "pliant/base/choices.hpp"
#include "pliant/model/contacts/contact_file.hpp"
#include "pliant/model/model.hpp"
#include "pliant/model/rigidity/rigidity_network.hpp"
#include "support/error_text.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant {
namespace contact_kinds_test {

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
  const std::string refusal = test::error_text<OptionError>(
      [] { find_contacts(four_atoms(), {.more_contacts = {"cation_pie"}}); });
  EXPECT_EQ(refusal,
            unknown_choice("kind of contact", "cation_pie", names_of(molecular_contact_kinds())));
  EXPECT_EQ(test::error_text<OptionError>([] {
              build_model(four_atoms(), {.more_contacts = {"cation_pi"},
                                         .contacts = std::vector<MolecularContact>{}});
            }),
            "more_contacts: goes with contacts that are found, not with given ones");
}

}  // namespace contact_kinds_test
}  // namespace pliant
