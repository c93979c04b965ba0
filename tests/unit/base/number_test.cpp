// SPDX-License-Identifier: MIT
#include "pliant/base/number.hpp"

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(ParseReal, TakesWholeFiniteDecimalFields) {
  EXPECT_EQ(parse_real("1.5"), 1.5);
  EXPECT_EQ(parse_real("  -0.25\t"), -0.25);
  EXPECT_EQ(parse_real("+.5"), 0.5);
  EXPECT_EQ(parse_real("1."), 1.0);
  EXPECT_EQ(parse_real("1.458E+0"), 1.458);
  EXPECT_EQ(parse_real("1.0D+01"), 10.0);
  EXPECT_EQ(parse_real("1.0d-1"), 0.1);
}

TEST(ParseReal, RefusesEverythingElse) {
  for (const char* text :
       {"",         " ",   "nan", "-nan", "inf", "-inf", "1,5", "1.4x8", "0x10", "1e400",
        "********", "+-1", "++1", "--1",  "1 2", ".",    "-",   "+",     "1e",   "1.0D"})
    EXPECT_EQ(parse_real(text), std::nullopt) << text;
}

TEST(ParseInteger, TakesWholeDecimalFields) {
  EXPECT_EQ(parse_integer(" 42 "), 42);
  EXPECT_EQ(parse_integer("-7"), -7);
  EXPECT_EQ(parse_integer("+7"), 7);
  EXPECT_EQ(parse_integer("9223372036854775807"), 9223372036854775807);
}

TEST(ParseInteger, RefusesEverythingElse) {
  for (const char* text : {"", "3.0", "1e3", "0x10", "9223372036854775808", "+-1", "1a"})
    EXPECT_EQ(parse_integer(text), std::nullopt) << text;
}

}  // namespace
}  // namespace pliant
