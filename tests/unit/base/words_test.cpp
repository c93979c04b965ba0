// SPDX-License-Identifier: MIT
#include "pliant/base/words.hpp"

#include "pliant/base/choices.hpp"
#include "pliant/base/letters.hpp"
#include "pliant/base/printable.hpp"
#include "support/test.hpp"

namespace pliant::words_test {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Words, AreSetApartByBlanksAndEndWithAComment) {
  EXPECT_THAT(words_of(" push  C1\t1 2 3\r"), ElementsAre("push", "C1", "1", "2", "3"));
  EXPECT_THAT(words_of("bar a b# tree"), ElementsAre("bar", "a", "b"));
  EXPECT_THAT(words_of("# nothing"), IsEmpty());
  EXPECT_THAT(words_of(" \t\r"), IsEmpty());
  EXPECT_THAT(words_of(""), IsEmpty());
}

TEST(Words, AreReadBackAsOne) {
  EXPECT_TRUE(is_word("C1'"));
  for (const char* text : {"", "C 1", "#", "a#b", "a\tb", "a\nb"}) EXPECT_FALSE(is_word(text));
}

TEST(Letters, AreThoseFromAToZ) {
  for (const char c : {'A', 'M', 'Z'})
    EXPECT_TRUE(is_upper(c) && is_letter(c) && !is_lower(c)) << c;
  for (const char c : {'a', 'm', 'z'})
    EXPECT_TRUE(is_lower(c) && is_letter(c) && !is_upper(c)) << c;
  for (const char c : {'@', '[', '`', '{', '0', ' ', '\xc4'}) EXPECT_FALSE(is_letter(c)) << c;
}

TEST(Letters, ChangeCaseAlone) {
  EXPECT_EQ(upper_case("1abc.pdb \xc3\xa4"), "1ABC.PDB \xc3\xa4");
  EXPECT_EQ(lower_case("1ABC.Pdb \xc3\x84"), "1abc.pdb \xc3\x84");
}

struct Fruit {
  std::string_view name;
  int stones;
};
constexpr Fruit fruits[] = {{"apple", 0}, {"plum", 1}, {"cherry", 1}};

TEST(EditDistance, CountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("abc", "abc"), 0u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);  // Levenshtein's textbook pair
  EXPECT_EQ(edit_distance("sunday", "saturday"), 3u);
  EXPECT_EQ(edit_distance("ab", "ba"), 2u);
}

TEST(EditDistance, IsAMetric) {
  const std::string words[] = {"bfs_cycle", "bsf_cycle", "dfs_cycle", "bfs", "", "random"};
  for (const auto& a : words)
    for (const auto& b : words) {
      EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
      for (const auto& c : words)
        EXPECT_LE(edit_distance(a, c), edit_distance(a, b) + edit_distance(b, c));
    }
}

TEST(NearestName, IsWithinAThirdOfTheWord) {
  const std::vector<std::string_view> names{"random", "bfs_tree", "bfs_cycle"};
  EXPECT_EQ(nearest_name("bsf_cycle", names), "bfs_cycle");
  EXPECT_EQ(nearest_name("bfs-tree", names), "bfs_tree");
  EXPECT_EQ(nearest_name("RANDOM", names), "");
  EXPECT_EQ(nearest_name("x", names), "");
  EXPECT_EQ(nearest_name("", names), "");
}

TEST(NearestName, OfEquallyNearNamesTheFirst) {
  EXPECT_EQ(nearest_name("cat", {"bat", "rat"}), "bat");
}

TEST(Choose, FindsTheRow) { EXPECT_EQ(choose(fruits, "fruit", "plum").stones, 1); }

TEST(Choose, NamesTheNearestAndAllKnown) {
  EXPECT_ERROR(OptionError,
               "no fruit named \"plumm\" (did you mean \"plum\"?); known: apple, plum, cherry",
               choose(fruits, "fruit", "plumm"));
  EXPECT_ERROR(OptionError, "no fruit named \"banana\\x0a\"; known: apple, plum, cherry",
               choose(fruits, "fruit", "banana\n"));
}

TEST(NamesOf, IsTheColumnOfNames) {
  EXPECT_EQ(names_of(fruits), (std::vector<std::string_view>{"apple", "plum", "cherry"}));
}

TEST(At, NamesFileAndLine) {
  EXPECT_EQ(at({"a.pdb", 12}, "what"), "a.pdb:12: what");
  EXPECT_EQ(at({"a.pdb", 0}, "what"), "a.pdb: what");
  EXPECT_EQ(at({"\x1b[2J.pdb", 3}, "wrong"), "\"\\x1b[2J.pdb\":3: wrong");
}

TEST(Fail, ThrowsAnInputErrorWithThePlace) {
  EXPECT_ERROR(InputError, "b.xyz:3: expected a number", fail({"b.xyz", 3}, "expected a number"));
}

TEST(Quoted, EscapesWhatATerminalMightObey) {
  EXPECT_EQ(quoted("CA"), "\"CA\"");
  EXPECT_EQ(quoted(""), "\"\"");
  EXPECT_EQ(quoted("\x1b[2J"), "\"\\x1b[2J\"");
  EXPECT_EQ(quoted("a\tb\n"), "\"a\\x09b\\x0a\"");
  EXPECT_EQ(quoted(std::string_view("\0", 1)), "\"\\x00\"");
  EXPECT_EQ(quoted("\x7f\xc3\xa9\xff"), "\"\\x7f\\xc3\\xa9\\xff\"");
  EXPECT_EQ(quoted("say \"hi\" \\"), "\"say \\\"hi\\\" \\\\\"");
}

TEST(Quoted, ShortensAndSaysSo) {
  const std::string many(2000000, 'a'), forty(40, 'a');
  const std::string_view text = many;
  EXPECT_EQ(quoted(text.substr(0, 40)), '"' + forty + '"');
  EXPECT_EQ(quoted(text.substr(0, 41)), '"' + forty + "...\"");
  EXPECT_EQ(quoted(text, 3), "\"aaa...\"");
}

TEST(Quoted, HoldsNothingBeyondPrintableAscii) {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  for (unsigned char c : quoted(std::string_view(all), 256)) EXPECT_TRUE(c >= 0x20 && c <= 0x7e);
}

TEST(Printable, WritesOrdersToTerminalsAndWhatIsNoUtf8AsHex) {
  for (const char* text :
       {"", "a b", "M\xc3\xbcller", "\xe6\xb0\xb4", "\xf0\x9f\xa7\xac", "a\tb\n"})
    EXPECT_EQ(printable(text), text);
  const std::pair<const char*, const char*> cases[] = {
      {"\x1b[31mred\x07", "\\x1b[31mred\\x07"},
      {"a\x7f\r", "a\\x7f\\x0d"},
      {"\xc2\x9b[J", "\\xc2\\x9b[J"},  // the one-byte order of ISO 6429
      {"\xff", "\\xff"},
      {"\x9b[J", "\\x9b[J"},
      {"\xc3", "\\xc3"},                     // cut
      {"\xe0\x80\x9b", "\\xe0\\x80\\x9b"},   // longer than it need be
      {"\xed\xa0\x80", "\\xed\\xa0\\x80"}};  // half of a pair
  for (const auto& [text, shown] : cases) EXPECT_EQ(printable(text), shown);
}

TEST(Printable, NamesAreQuotedWhereTheyMust) {
  EXPECT_EQ(printable_name("a b.pdb"), "a b.pdb");
  EXPECT_EQ(printable_name("M\xc3\xbcller.pdb"), "M\xc3\xbcller.pdb");
  EXPECT_EQ(printable_name("a\nb"), "\"a\\x0ab\"");
  EXPECT_EQ(printable_name("\x1b]0;x\x07.pdb"), "\"\\x1b]0;x\\x07.pdb\"");
  EXPECT_EQ(printable_name("say \"hi\""), "\"say \\\"hi\\\"\"");
}

}  // namespace pliant::words_test
