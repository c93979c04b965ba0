// SPDX-License-Identifier: MIT
#include "pliant/base/letters.hpp"

#include <gtest/gtest.h>

namespace pliant {
namespace {

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

}  // namespace
}  // namespace pliant
