// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/hybrid36.hpp"

#include <gtest/gtest.h>

namespace pliant {
namespace hybrid36_test {

// The borders that cci.lbl.gov/hybrid_36 states for five and four columns.
TEST(Hybrid36, Borders) {
  EXPECT_EQ(parse_hybrid36("99999"), 99999);
  EXPECT_EQ(parse_hybrid36("A0000"), 100000);
  EXPECT_EQ(parse_hybrid36("ZZZZZ"), 43770015);
  EXPECT_EQ(parse_hybrid36("a0000"), 43770016);
  EXPECT_EQ(parse_hybrid36("zzzzz"), 87440031);
  EXPECT_EQ(parse_hybrid36("A000"), 10000);
  EXPECT_EQ(parse_hybrid36("ZZZZ"), 1223055);
  EXPECT_EQ(parse_hybrid36("a000"), 1223056);
  EXPECT_EQ(parse_hybrid36("zzzz"), 2436111);
}

TEST(Hybrid36, Decimal) {
  EXPECT_EQ(parse_hybrid36("   12"), 12);
  EXPECT_EQ(parse_hybrid36("12   "), 12);
  EXPECT_EQ(parse_hybrid36("  -5"), -5);
}

TEST(Hybrid36, WhatIsNone) {
  for (const char* field : {"", "     ", "*****", "A 000", " A000", "Aa000", "A00a0", "1A000",
                            "12 34", "A-000", "AAAAAAAAA"})
    EXPECT_EQ(parse_hybrid36(field), std::nullopt) << field;
}

TEST(Hexadecimal, OfVmd) {
  EXPECT_EQ(parse_vmd_hexadecimal("186a0"), 100000);
  EXPECT_EQ(parse_vmd_hexadecimal("186A0"), 100000);
  EXPECT_EQ(parse_vmd_hexadecimal(" 270f"), 9999);
  for (const char* field : {"18700", "a0000", "", "1g000", "1a2-3", "-1a", "*****"})
    EXPECT_EQ(parse_vmd_hexadecimal(field), std::nullopt) << field;
  EXPECT_EQ(parse_hexadecimal("18700"), 100096);
  EXPECT_EQ(parse_hexadecimal("a0000"), 655360);
  EXPECT_EQ(parse_hexadecimal("-1"), std::nullopt);
  EXPECT_EQ(parse_hexadecimal(""), std::nullopt);
}

}  // namespace hybrid36_test
}  // namespace pliant
