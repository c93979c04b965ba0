// SPDX-License-Identifier: MIT
#include "pliant/base/error.hpp"

#include <gtest/gtest.h>

#include "support/error_text.hpp"

namespace pliant {
namespace error_test {

TEST(At, NamesFileAndLine) {
  EXPECT_EQ(at({"a.pdb", 12}, "what"), "a.pdb:12: what");
  EXPECT_EQ(at({"a.pdb", 0}, "what"), "a.pdb: what");
}

TEST(Fail, ThrowsAnInputErrorWithThePlace) {
  EXPECT_EQ(test::error_text<InputError>([] {
              fail({"b.xyz", 3}, "expected a number");
            }),
            "b.xyz:3: expected a number");
}

TEST(Errors, AreAllErrors) {
  EXPECT_THROW(throw InputError("x"), Error);
  EXPECT_THROW(throw OptionError("x"), Error);
  EXPECT_THROW(throw FileError("x"), Error);
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

}  // namespace error_test
}  // namespace pliant
