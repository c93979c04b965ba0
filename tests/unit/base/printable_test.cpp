// SPDX-License-Identifier: MIT
#include "pliant/base/printable.hpp"

#include <gtest/gtest.h>

#include "pliant/base/error.hpp"

namespace pliant {
namespace printable_test {

TEST(Printable, LeavesTextOfAllScripts) {
  for (const char* text :
       {"", "a b", "M\xc3\xbcller", "\xe6\xb0\xb4", "\xf0\x9f\xa7\xac", "a\tb\n"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, WritesOrdersToTerminalsAsHex) {
  EXPECT_EQ(printable("\x1b[31mred\x07"), "\\x1b[31mred\\x07");
  EXPECT_EQ(printable("a\x7f\r"), "a\\x7f\\x0d");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\xc2\\x9b2J")
      << "the one-byte order of ISO 6429";
}

TEST(Printable, WritesWhatIsNoUtf8AsHex) {
  EXPECT_EQ(printable("\xff"), "\\xff");
  EXPECT_EQ(printable("\x9b"
                      "2J"),
            "\\x9b2J");
  EXPECT_EQ(printable("\xc3"), "\\xc3") << "cut";
  EXPECT_EQ(printable("\xe0\x80\x9b"), "\\xe0\\x80\\x9b") << "longer than it need be";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
}

TEST(Printable, NamesAreQuotedWhereTheyMust) {
  EXPECT_EQ(printable_name("a b.pdb"), "a b.pdb");
  EXPECT_EQ(printable_name("M\xc3\xbcller.pdb"), "M\xc3\xbcller.pdb");
  EXPECT_EQ(printable_name("a\nb"), "\"a\\x0ab\"");
  EXPECT_EQ(printable_name("\x1b]0;x\x07.pdb"), "\"\\x1b]0;x\\x07.pdb\"");
  EXPECT_EQ(printable_name("say \"hi\""), "\"say \\\"hi\\\"\"");
}

TEST(Printable, PlacesAreNamedSo) {
  EXPECT_EQ(at({"a.pdb", 3}, "wrong"), "a.pdb:3: wrong");
  EXPECT_EQ(at({"\x1b[2J.pdb", 3}, "wrong"), "\"\\x1b[2J.pdb\":3: wrong");
}

}  // namespace printable_test
}  // namespace pliant
