// SPDX-License-Identifier: MIT
#include "pliant/text/text_lines.hpp"

#include <gtest/gtest.h>

#include <ctime>
#include <string>
#include <vector>

namespace pliant {
namespace text_lines_test {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> found;
  for (Lines lines(text); lines.next();) found.emplace_back(lines.line());
  return found;
}

using Text = std::vector<std::string>;

TEST(Lines, AnyLineEnd) {
  EXPECT_EQ(lines_of("a\nb\n"), (Text{"a", "b"}));
  EXPECT_EQ(lines_of("a\r\nb\r\n"), (Text{"a", "b"}));
  EXPECT_EQ(lines_of("a\rb\r"), (Text{"a", "b"}));
  EXPECT_EQ(lines_of("a\rb\nc\r\nd"), (Text{"a", "b", "c", "d"}));
  EXPECT_EQ(lines_of("a\r\r\nb"), (Text{"a", "", "b"}));
}

TEST(Lines, EmptyLinesAndEnds) {
  EXPECT_EQ(lines_of(""), Text{});
  EXPECT_EQ(lines_of("\n"), Text{""});
  EXPECT_EQ(lines_of("\n\nx"), (Text{"", "", "x"}));
  EXPECT_EQ(lines_of("x\n\n"), (Text{"x", ""}));
}

TEST(Lines, CountsAndRemembersItsPlaceWhenCopied) {
  Lines lines("a\nb\nc");
  EXPECT_EQ(lines.number(), 0u);
  lines.next();
  Lines copy = lines;
  EXPECT_TRUE(lines.next() && lines.next());
  EXPECT_EQ(lines.number(), 3u);
  EXPECT_FALSE(lines.next());
  EXPECT_EQ(lines.number(), 3u);
  EXPECT_TRUE(copy.next());
  EXPECT_EQ(copy.line(), "b");
  EXPECT_EQ(copy.number(), 2u);
}

/// Looking for an LF from every line of a text without any would take 10^12 steps here.
TEST(Lines, LinearWhereOneKindOfLineEndIsMissing) {
  const std::string text(1'000'000, '\r');
  const std::clock_t begin = std::clock();  // of this process: others may be busy
  EXPECT_EQ(lines_of(text).size(), text.size());
  EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
}

}  // namespace text_lines_test
}  // namespace pliant
