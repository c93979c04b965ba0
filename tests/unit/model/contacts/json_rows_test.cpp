// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/json_rows.hpp"

#include <gtest/gtest.h>

#include "support/error_text.hpp"

namespace pliant {
namespace json_rows_test {

std::vector<JsonRow> rows(std::string_view text) {
  return parse_json_rows({"c.json", text}, "list");
}

std::string fault_of(std::string_view text) {
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
  EXPECT_EQ(fault_of("[]"), "c.json:1: expected {, found \"[\"");
  EXPECT_EQ(fault_of("{\"rows\": []}"), "c.json:1: expected \"list\", found \"rows\"");
  EXPECT_EQ(fault_of("{\"list\":\n[{\"a\": 1]}"), "c.json:2: expected }, found \"]\"");
  EXPECT_EQ(fault_of("{\"list\": [{\"a\": true}]}"),
            "c.json:1: expected a text, a number or null, found \"t\"");
  EXPECT_EQ(fault_of("{\"list\": [{\"a\": [1]}]}"),
            "c.json:1: expected a text, a number or null, found \"[\"");
  EXPECT_EQ(fault_of("{\"list\": [{\"a\": 1, \"a\": 2}]}"), "c.json:1: \"a\" is given twice");
  EXPECT_EQ(fault_of("{\"list\": [{\"a\": 1.}]}"),
            "c.json:1: expected a text, a number or null, found \"}\"");
  EXPECT_EQ(fault_of("{\"list\": [{\"a\": \"\\x\"}]}"),
            "c.json:1: expected a letter of an escape after \\, found \"x\"");
  EXPECT_EQ(fault_of("{\"list\": [{\"a\": \"\\u00g0\"}]}"),
            "c.json:1: expected four hexadecimal digits, found \"g\"");
  EXPECT_EQ(fault_of("{\"list\": [{\"a\": \"\\ude00\"}]}"),
            "c.json:1: expected the first half of a pair before, found the second");
  EXPECT_EQ(fault_of("{\"list\": []} 1"), "c.json:1: expected nothing more, found \"1\"");
}

TEST(JsonRows, AnyTextCutShortIsRefused) {
  const std::string_view whole =
      "{\"list\": [{\"a\": \"\\ud83d\\ude00\", \"b\": -1e5}, {\"c\": null}]}";
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_TRUE(fault_of(whole.substr(0, size)).starts_with("c.json:1: expected ")) << size;
}

}  // namespace json_rows_test
}  // namespace pliant
