// SPDX-License-Identifier: MIT
#include "pliant/base/elements.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pliant {
namespace elements_test {

TEST(Elements, SymbolAndNumberAreInverse) {
  for (int z = 1; z <= element_count; ++z) {
    const auto number = static_cast<std::uint8_t>(z);
    EXPECT_EQ(element_number(element_symbol(number)), number);
    EXPECT_GT(element_mass(number), 1.0);
    EXPECT_EQ(covalent_radius(number) > 0.0, z <= 96) << z;
  }
}

TEST(Elements, SymbolsInAnyCaseAndIsotopesOfHydrogen) {
  EXPECT_EQ(element_number("CL"), 17);
  EXPECT_EQ(element_number("cl"), 17);
  EXPECT_EQ(element_number("Cl"), 17);
  EXPECT_EQ(element_number("D"), 1);
  EXPECT_EQ(element_number("T"), 1);
}

TEST(Elements, WhatIsNoSymbol) {
  for (const char* word : {"", "X", "Xx", "Qq", "C1", "Cla", " C", "\xc3\x84", "[", "@", "A`"})
    EXPECT_EQ(element_number(word), 0) << word;
  EXPECT_EQ(element_symbol(0), "X");
  EXPECT_EQ(element_symbol(119), "X");
  EXPECT_EQ(element_mass(0), 1.0);
  EXPECT_EQ(covalent_radius(0), 0.0);
  EXPECT_FALSE(is_metal(0));
}

// Cordero et al. 2008, table 2; IUPAC 2021.
TEST(Elements, KnownValues) {
  EXPECT_EQ(covalent_radius(1), 0.31);
  EXPECT_EQ(covalent_radius(6), 0.76);
  EXPECT_EQ(covalent_radius(26), 1.32);
  EXPECT_EQ(covalent_radius(96), 1.69);
  EXPECT_EQ(element_mass(6), 12.011);
  EXPECT_EQ(element_mass(92), 238.02891);
}

TEST(Elements, Metals) {
  for (const char* symbol : {"Li", "Na", "Mg", "Ca", "Al", "Fe", "Zn", "Sn", "Pb", "Bi", "Po", "U"})
    EXPECT_TRUE(is_metal(element_number(symbol))) << symbol;
  for (const char* symbol : {"H", "He", "B", "C", "Si", "P", "S", "Se", "Te", "I", "As", "Rn"})
    EXPECT_FALSE(is_metal(element_number(symbol))) << symbol;
}

}  // namespace elements_test
}  // namespace pliant
