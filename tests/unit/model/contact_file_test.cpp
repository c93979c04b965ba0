// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/contact_file.hpp"

#include "pliant/model/contacts/json_rows.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::contact_file_test {

using namespace test;

/// Two residues: N, H and two C of the one, O and C of the other.
Structure two_residues() {
  Structure s;
  add_residue(s, "GLY", 1,
              {{"N", "N", {0, 0, 0}}, {"H", "H", {1.0, 0, 0}}, {"CA", "C", {-1.4, 0, 0}}});
  add_residue(s, "ALA", 5, {{"O", "O", {2.9, 0, 0}}, {"C", "C", {4.1, 0, 0}}});
  return s;
}

std::vector<MolecularContact> two_contacts(const Structure& s) {
  MolecularContact bond{MolecularContactKind::hydrogen_bond, 0, 3, 1, 4, -5.25};
  set_limits(bond, s);
  MolecularContact tether{MolecularContactKind::hydrophobic, 2, 4};
  tether.energy = -1.0;
  set_limits(tether, s, 3.4);
  return {bond, tether};
}

std::string fault_of(std::string_view text) {
  return test::error_text<InputError>([&] { parse_contacts({"c.csv", text}, two_residues()); });
}

TEST(ContactFile, IsReadBackToTheSameBits) {
  const Structure s = two_residues();
  std::vector<MolecularContact> contacts = two_contacts(s);
  contacts[0].energy = -0.1 - 1e-16;
  const std::string text = contacts_as_csv(contacts, s);
  EXPECT_EQ(parse_contacts({"c.csv", text}, s), contacts);
  EXPECT_EQ(parse_contacts({"c.json", contacts_as_json(contacts, s)}, s), contacts);
  EXPECT_TRUE(parse_contacts({"c.json", contacts_as_json({}, s)}, s).empty());
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "kind,a,b,hydrogen,base,energy,distance,least,most,hydrogen_most,base_least,base_most");
  EXPECT_NE(text.find("\nhydrogen_bond,A:GLY1:N,A:ALA5:O,A:GLY1:H,A:ALA5:C,"), text.npos);
  EXPECT_NE(text.find("\nhydrophobic,A:GLY1:CA,A:ALA5:C,,,-1,5.5,0,6,,,\n"), text.npos);
}

TEST(ContactFile, WhatIsLeftOutIsMeasured) {
  const Structure s = two_residues();
  const SourceText texts[] = {
      {"c.csv", "b, a, kind, hydrogen, base\n# the only one\n3,A:GLY1:N,hydrogen_bond,1,4\n"},
      {"c.json",
       "{\"contacts\": [{\"b\": 3, \"a\": \"A:GLY1:N\", \"kind\": \"hydrogen_bond\", "
       "\"hydrogen\": 1, \"base\": 4}]}"}};
  for (const SourceText& text : texts) {
    const auto contacts = parse_contacts(text, s);
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].most, 3.1);
    EXPECT_EQ(contacts[0].energy, -1.0);
  }
}

TEST(ContactFile, SaysWhatIsWrong) {
  const std::string bond = "kind,a,b,hydrogen,base\nhydrogen_bond,0,3,1,4\n";
  const std::pair<std::string, const char*> cases[] = {
      {"", ": expected a line of column names with kind, a and b, found no text"},
      {"kind,a\n", ":1: there is no column \"b\""},
      {"kind,a,b,a\n", ":1: column \"a\" is given twice"},
      {"kind,a,b,enrgy\n", ":1: no column named \"enrgy\" (did you mean \"energy\"?)"},
      {"kind,a,b\nhydrophobic,2\n", ":2: expected 3 fields, found 2"},
      {"kind,a,b\nhydrophobic,2,A:ALA5:CB\n", ":2: there is no atom called \"A:ALA5:CB\""},
      {"kind,a,b\nhydrophobic,2,9\n", ":2: there is no atom \"9\": there are 5, counted from 0"},
      {"kind,a,b\nhydrophobic,2,2\n", ":2: a, b: expected two atoms, found one twice"},
      {"kind,a,b\nhydrophobic,2,4\nhydrophobic,4,2\n",
       ":3: a, b: these two are in contact already, by line 2"},
      {"kind,a,b\nhydrogen_bond,0,3\n", ":2: hydrogen: expected an atom, found nothing"},
      {"kind,a,b,most\nhydrophobic,2,4,nan\n",
       ":2: most: expected a number from 0 to 100000, found \"nan\""},
      {"kind,a,b,least,most\nhydrophobic,2,4,5,4\n", ":2: least: expected at most 4, found \"5\""},
      {bond + "hydrogen_bond,0,3,1,4\n",
       ":3: a, b, hydrogen: these three are in contact already, by line 2"},
      {bond + "salt_bridge,3,0,1,2\n",
       ":3: a, b, hydrogen: these three are in contact already, by line 2"}};
  for (const auto& [text, fault] : cases)
    EXPECT_THAT(fault_of(text), testing::StartsWith("c.csv" + std::string(fault)));
}

/// Each binds the other by its own hydrogen.
TEST(ContactFile, TwoBondsOfOnePairOfHydroxylsAreReadBack) {
  Structure s;
  for (int residue : {1, 5})
    add_residue(s, "SER", residue,
                {{"CB", "C", {0.0, 0.0, 2.8 * residue}},
                 {"OG", "O", {1.4, 0.0, 2.8 * residue}},
                 {"HG", "H", {1.7, 0.9, 2.8 * residue}}});
  MolecularContact there{MolecularContactKind::hydrogen_bond, 1, 4, 2, 3, -2.5};
  MolecularContact back{MolecularContactKind::hydrogen_bond, 4, 1, 5, 0, -1.5};
  set_limits(there, s);
  set_limits(back, s);
  const std::vector<MolecularContact> contacts{there, back};
  EXPECT_EQ(parse_contacts({"c.csv", contacts_as_csv(contacts, s)}, s), contacts);
  EXPECT_EQ(parse_contacts({"c.json", contacts_as_json(contacts, s)}, s), contacts);
}

TEST(ContactFile, AsJsonHasNullForWhatThereIsNot) {
  const Structure s = two_residues();
  const std::string text = contacts_as_json(two_contacts(s), s);
  EXPECT_NE(text.find("{\"kind\": \"hydrophobic\", \"a\": \"A:GLY1:CA\", \"b\": \"A:ALA5:C\", "
                      "\"hydrogen\": null, \"base\": null, \"energy\": -1, "),
            text.npos);
}

TEST(ContactFile, SaysWhatIsWrongInJson) {
  const auto fault = [](const std::string& rows) {
    return fault_of("{\"contacts\": [\n" + rows + "\n]}");
  };
  const std::string tether = "{\"kind\": \"hydrophobic\", \"a\": 2, \"b\": 4}";
  EXPECT_EQ(fault("{\"kind\": \"hydrophobic\", \"a\": 2}"), "c.csv:2: there is no \"b\"");
  EXPECT_EQ(fault("{\"enrgy\": 1}").substr(0, 56),
            "c.csv:2: no column named \"enrgy\" (did you mean \"energy\"?");
  EXPECT_EQ(fault(tether + ",\n" + tether),
            "c.csv:3: a, b: these two are in contact already, by line 2");
  EXPECT_EQ(fault("{\"kind\": \"hydrophobic\", \"a\": 2, \"b\": 4, \"most\": \"far\"}"),
            "c.csv:2: most: expected a number from 0 to 100000, found \"far\"");
}

std::vector<JsonRow> rows(std::string_view text) {
  return parse_json_rows({"c.json", text}, "list");
}

std::string row_fault_of(std::string_view text) {
  return test::error_text<InputError>([&] { rows(text); });
}

TEST(JsonRows, ValuesAreAsTheyAreMeant) {
  const auto found = rows(
      " {\"list\" :\n[ {\"a\": \"x \\\"y\\\" \\\\ \\/ \\u0041\\u00e5\\u20ac\\ud83d\\ude00\\n\", "
      "\"b\": -1.5e-3,\n"
      "\"c\": null}\n,{}, {\"a\":0}] }\n");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].line, 2U);
  EXPECT_EQ(found[2].line, 4U);
  EXPECT_EQ(found[0].cells.at("a"), "x \"y\" \\ / A\xc3\xa5\xe2\x82\xac\xf0\x9f\x98\x80\n");
  EXPECT_EQ(found[0].cells.at("b"), "-1.5e-3");
  EXPECT_EQ(found[0].cells.at("c"), "");
  EXPECT_TRUE(found[1].cells.empty());
  EXPECT_TRUE(rows("{\"list\": []}").empty());
}

TEST(JsonRows, OnlyBracesAndBracketsLookLikeIt) {
  EXPECT_TRUE(looks_like_json("\n {"));
  EXPECT_TRUE(looks_like_json("["));
  EXPECT_FALSE(looks_like_json("kind,a,b"));
  EXPECT_FALSE(looks_like_json(""));
}

TEST(JsonRows, SaysWhatIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"[]", "1: expected {, found \"[\""},
      {"{\"rows\": []}", "1: expected \"list\", found \"rows\""},
      {"{\"list\":\n[{\"a\": 1]}", "2: expected }, found \"]\""},
      {"{\"list\": [{\"a\": true}]}", "1: expected a text, a number or null, found \"t\""},
      {"{\"list\": [{\"a\": [1]}]}", "1: expected a text, a number or null, found \"[\""},
      {"{\"list\": [{\"a\": 1, \"a\": 2}]}", "1: \"a\" is given twice"},
      {"{\"list\": [{\"a\": 1.}]}", "1: expected a text, a number or null, found \"}\""},
      {"{\"list\": [{\"a\": \"\\x\"}]}", "1: expected a letter of an escape after \\, found \"x\""},
      {"{\"list\": [{\"a\": \"\\u00g0\"}]}", "1: expected four hexadecimal digits, found \"g\""},
      {"{\"list\": [{\"a\": \"\\ude00\"}]}",
       "1: expected the first half of a pair before, found the second"},
      {"{\"list\": []} 1", "1: expected nothing more, found \"1\""}};
  for (const auto& [text, fault] : cases)
    EXPECT_EQ(row_fault_of(text), "c.json:" + std::string(fault));
}

TEST(JsonRows, AnyTextCutShortIsRefused) {
  const std::string_view whole =
      "{\"list\": [{\"a\": \"\\ud83d\\ude00\", \"b\": -1e5}, {\"c\": null}]}";
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_TRUE(row_fault_of(whole.substr(0, size)).starts_with("c.json:1: expected ")) << size;
}

}  // namespace pliant::contact_file_test
