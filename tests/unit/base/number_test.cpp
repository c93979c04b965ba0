// SPDX-License-Identifier: MIT
#include "pliant/base/number.hpp"

#include <clocale>

#include "pliant/base/elements.hpp"
#include "pliant/base/random.hpp"
#include "pliant/base/range.hpp"
#include "pliant/base/wide_product.hpp"
#include "support/test.hpp"

namespace pliant::number_test {

using Block = std::array<std::uint64_t, 4>;

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

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST(Range, HoldsItsEndsAndNothingBeyond) {
  EXPECT_TRUE(holds(Range::zero_to_one, 0.0));
  EXPECT_TRUE(holds(Range::zero_to_one, 1.0));
  EXPECT_FALSE(holds(Range::zero_to_one, 1.0 + 1e-15));
  EXPECT_FALSE(holds(Range::positive, 0.0));
  EXPECT_TRUE(holds(Range::positive, std::numeric_limits<double>::denorm_min()));
  EXPECT_TRUE(holds(Range::zero_or_more, 0.0));
  EXPECT_FALSE(holds(Range::zero_or_more, -1e-300));
  EXPECT_TRUE(holds(Range::positive, std::int64_t{1}));
  EXPECT_FALSE(holds(Range::positive, std::int64_t{0}));
  EXPECT_FALSE(holds(Range::zero_or_more, std::int64_t{-1}));
}

TEST(Range, HoldsFiniteNumbersOnly) {
  for (Range range : {Range::any, Range::positive, Range::zero_or_more, Range::zero_to_one}) {
    EXPECT_FALSE(holds(range, infinite));
    EXPECT_FALSE(holds(range, not_a_number));
  }
}

TEST(Range, SaysWhatMustBe) {
  const auto refusal = [](auto value, Range range) {
    return test::error_text<OptionError>([&] { check_range("size", value, range); });
  };
  EXPECT_EQ(refusal(0.0, Range::positive), "size = 0: must be positive and finite");
  EXPECT_EQ(refusal(-1.0, Range::zero_or_more), "size = -1: must be 0 or more and finite");
  EXPECT_EQ(refusal(2.0, Range::zero_to_one), "size = 2: must be from 0 to 1");
  EXPECT_EQ(refusal(infinite, Range::any), "size = inf: must be finite");
  EXPECT_EQ(refusal(std::int64_t{0}, Range::positive), "size = 0: must be from 1");
  EXPECT_EQ(refusal(std::int64_t{-3}, Range::zero_or_more), "size = -3: must be from 0");
}

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

constexpr std::uint64_t all_ones = ~std::uint64_t{0};

// (2^64 - 1)^2 = 2^128 - 2^65 + 1.
static_assert(wide_product_of_halves(all_ones, all_ones) == WideProduct{all_ones - 1, 1});
static_assert(wide_product_of_halves(1u << 31, 2) == WideProduct{0, std::uint64_t{1} << 32});
static_assert(wide_product_of_halves(std::uint64_t{1} << 63, 2) == WideProduct{1, 0});

TEST(WideProduct, HalvesGiveWhatTheProcessorGives) {
  for (std::uint64_t k = 0; k < 20000; ++k) {
    const auto draws = philox4x64({k, 0, 0, 0}, {1, 2});
    for (std::uint64_t a : {draws[0], draws[0] >> 40, all_ones})
      for (std::uint64_t b : {draws[1], draws[1] >> 33, all_ones})
        ASSERT_EQ(wide_product(a, b), wide_product_of_halves(a, b)) << a << " " << b;
  }
}

/// Known answers of Random123 (kat_vectors, philox4x64 10): counters and keys of zeros, of ones,
/// and of the digits of pi.
TEST(Philox, GivesTheKnownAnswersOfRandom123) {
  constexpr std::uint64_t ones = ~std::uint64_t{0};
  EXPECT_EQ(philox4x64({0, 0, 0, 0}, {0, 0}), (Block{0x16554d9eca36314cu, 0xdb20fe9d672d0fdcu,
                                                     0xd7e772cee186176bu, 0x7e68b68aec7ba23bu}));
  EXPECT_EQ(
      philox4x64({ones, ones, ones, ones}, {ones, ones}),
      (Block{0x87b092c3013fe90bu, 0x438c3c67be8d0224u, 0x9cc7d7c69cd777b6u, 0xa09caebf594f0ba0u}));
  EXPECT_EQ(
      philox4x64(
          {0x243f6a8885a308d3u, 0x13198a2e03707344u, 0xa4093822299f31d0u, 0x082efa98ec4e6c89u},
          {0x452821e638d01377u, 0xbe5466cf34e90c6cu}),
      (Block{0xa528f45403e61d95u, 0x38c72dbd566e9788u, 0xa5a1610e72fd18b5u, 0x57bd43b5e52b7fe6u}));
}

TEST(RandomSequence, DependsOnEachFieldOfItsKey) {
  std::set<std::uint64_t> first;
  const RandomKey keys[] = {
      {},          {.seed = 1}, {.domain = Domain::force}, {.domain = Domain::order}, {.walker = 1},
      {.step = 1}, {.joint = 1}};
  for (const RandomKey& key : keys) first.insert(RandomSequence(key).bits());
  EXPECT_EQ(first.size(), std::size(keys));
}

TEST(RandomSequence, IsTheBlocksOfItsKeyOneAfterTheOther) {
  RandomSequence draws({7, Domain::force, 8, 9, 10});
  for (std::uint64_t block = 0; block < 3; ++block)
    for (std::uint64_t word : philox4x64({9, 10, 8, block}, {7, 2})) EXPECT_EQ(draws.bits(), word);
}

TEST(RandomSequence, UniformIsInTheUnitIntervalWithItsMoments) {
  RandomSequence draws({.seed = 3});
  double sum = 0.0, squares = 0.0;
  constexpr int count = 100000;
  for (int k = 0; k < count; ++k) {
    const double u = draws.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  EXPECT_NEAR(sum / count, 1.0 / 2.0, 0.005);
  EXPECT_NEAR(squares / count, 1.0 / 3.0, 0.005);
}

TEST(RandomSequence, BelowIsEven) {
  RandomSequence draws({.seed = 4});
  int hits[7] = {};
  for (int k = 0; k < 70000; ++k) ++hits[draws.below(7)];
  for (int count : hits) EXPECT_NEAR(count, 10000, 500);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(draws.below(1), 0u);
}

/// A bound just above half of the range refuses nearly half of the draws: the way round is walked.
TEST(RandomSequence, BelowAHugeBoundIsBelowIt) {
  RandomSequence draws({.seed = 5});
  constexpr std::uint64_t bound = (std::uint64_t{1} << 63) + 1;
  int upper_half = 0;
  for (int k = 0; k < 10000; ++k) {
    const std::uint64_t drawn = draws.below(bound);
    ASSERT_LT(drawn, bound);
    upper_half += drawn > bound / 2;
  }
  EXPECT_NEAR(upper_half, 5000, 300);
}

TEST(RandomSequence, DirectionsAreUnitVectorsAllAround) {
  for (const bool planar : {false, true}) {
    RandomSequence draws({.seed = 6});
    Vec3 sum, squares, products;
    constexpr int count = 100000;
    for (int k = 0; k < count; ++k) {
      const Vec3 n = planar ? draws.direction_in_plane() : draws.direction();
      ASSERT_NEAR(norm(n), 1.0, 1e-15);
      sum += n;
      squares += {n.x * n.x, n.y * n.y, n.z * n.z};
      products += {n.x * n.y, n.y * n.z, n.z * n.x};
    }
    const Vec3 moments = planar ? Vec3{1.0 / 2, 1.0 / 2, 0} : Vec3{1.0 / 3, 1.0 / 3, 1.0 / 3};
    EXPECT_LT(norm((1.0 / count) * sum), 0.01);
    EXPECT_LT(norm((1.0 / count) * squares - moments), 0.006);
    EXPECT_LT(norm((1.0 / count) * products), 0.006);
    EXPECT_TRUE(!planar || squares.z == 0.0);
  }
}

TEST(Random, ManyDirectionsAreThoseOfEachJointAlone) {
  for (const bool planar : {false, true})
    for (const std::size_t count : {0u, 1u, 3u, 4u, 1000u}) {
      RandomKey key{5, Domain::displacement, 6, 7, 90};
      std::vector<Vec3> together(count);
      random_directions(key, planar, together);
      for (std::size_t i = 0; i < count; ++i) {
        key.joint = 90 + i;
        RandomSequence alone(key);
        EXPECT_EQ(together[i], planar ? alone.direction_in_plane() : alone.direction());
      }
    }
}

}  // namespace pliant::number_test
