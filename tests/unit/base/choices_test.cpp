// SPDX-License-Identifier: MIT
#include "pliant/base/choices.hpp"

#include <gtest/gtest.h>

#include "support/error_text.hpp"

namespace pliant {
namespace choices_test {

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
  EXPECT_EQ(test::error_text<OptionError>([] { choose(fruits, "fruit", "plumm"); }),
            "no fruit named \"plumm\" (did you mean \"plum\"?); known: apple, plum, cherry");
  EXPECT_EQ(test::error_text<OptionError>([] { choose(fruits, "fruit", "banana\n"); }),
            "no fruit named \"banana\\x0a\"; known: apple, plum, cherry");
}

TEST(NamesOf, IsTheColumnOfNames) {
  EXPECT_EQ(names_of(fruits), (std::vector<std::string_view>{"apple", "plum", "cherry"}));
}

}  // namespace choices_test
}  // namespace pliant
