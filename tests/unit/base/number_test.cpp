// SPDX-License-Identifier: MIT
#include "pliant/base/number.hpp"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <string>

namespace pliant {
namespace number_test {

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

TEST(NumberText, IsPrintfsGeneralFormat) {
  EXPECT_EQ(number_text(1.5), "1.5");
  EXPECT_EQ(number_text(-0.0), "-0");
  EXPECT_EQ(number_text(1e-7), "1e-07");
  EXPECT_EQ(number_text(1e300), "1e+300");
  EXPECT_EQ(number_text(1.0 / 3.0), "0.3333333333");
  EXPECT_EQ(number_text(2.0 / 3.0, 2), "0.67");
  EXPECT_EQ(number_text(1.00000001), "1.00000001");
  EXPECT_EQ(number_text(std::nan("")), "nan");
  EXPECT_EQ(number_text(-HUGE_VAL), "-inf");
}

TEST(NumberText, DoesNotFollowTheLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* name : {"de_DE.UTF-8", "tr_TR.UTF-8", "C.UTF-8"}) {
    if (std::setlocale(LC_NUMERIC, name) == nullptr) continue;
    EXPECT_EQ(number_text(1.5), "1.5") << name;
    EXPECT_EQ(parse_real("1.5"), 1.5) << name;
    EXPECT_EQ(parse_real("1,5"), std::nullopt) << name;
  }
  std::setlocale(LC_NUMERIC, before.c_str());
}

}  // namespace number_test
}  // namespace pliant
