// SPDX-License-Identifier: MIT
#include "pliant/model/steric_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "pliant/model/amplitude.hpp"
#include "support/error_text.hpp"
#include "unit/jobs/sampled_molecules.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant {
namespace steric_table_test {

std::map<std::string_view, long> kinds_of(const Structure& structure) {
  const auto names = steric_kind_names();
  std::map<std::string_view, long> counts;
  for (const std::uint16_t kind : molecular_sterics(structure, false).kinds) ++counts[names[kind]];
  return counts;
}

TEST(StericTable, KindsFollowElementsAndHydrogens) {
  EXPECT_EQ(kinds_of(test::model_of("butane.sdf").structure),
            (std::map<std::string_view, long>{{"C", 4}, {"HC", 10}}));
  EXPECT_EQ(kinds_of(test::model_of("aspirin.sdf").structure),
            (std::map<std::string_view, long>{{"C", 9}, {"H", 1}, {"HC", 7}, {"O", 3}, {"OH", 1}}));
}

/// Without any hydrogen it is not known which atoms donate.
TEST(StericTable, LigandsWithoutHydrogensMayDonate) {
  Structure s;
  test::add_residue(s, "LIG", 1, {{"O1", "O", {0, 0, 0}}, {"N1", "N", {9, 0, 0}}});
  EXPECT_EQ(kinds_of(s), (std::map<std::string_view, long>{{"NH", 1}, {"OH", 1}}));
}

TEST(StericTable, IsSymmetricAndThatOfThePages) {
  const Structure butane = test::model_of("butane.sdf").structure;
  const Sterics usual = molecular_sterics(butane, false), careful = molecular_sterics(butane, true);
  const auto names = steric_kind_names();
  const auto at = [&](const Sterics& table, std::string_view a, std::string_view b) {
    const auto row = [&](std::string_view name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    return table.least[row(a) * table.kind_count + row(b)];
  };
  for (std::string_view a : names)
    for (std::string_view b : names) EXPECT_EQ(at(careful, a, b), at(careful, b, a)) << a << b;
  EXPECT_EQ(at(usual, "C", "C"), 3.2);
  EXPECT_EQ(at(usual, "O", "H"), 1.7);
  EXPECT_EQ(at(usual, "HC", "HC"), 2.0);
  EXPECT_EQ(at(careful, "HC", "HC"), 2.06);
  EXPECT_EQ(at(careful, "HC", "C"), 2.54);
  EXPECT_EQ(at(careful, "C", "C"), 3.2);
}

/// B = 8 pi^2 <u^2> / 3: 26.3 Angstrom^2 is a fluctuation of 1 Angstrom.
TEST(Amplitude, OfBFactorsIsTheMeanFluctuation) {
  Structure s;
  for (int k = 0; k < 2; ++k) test::add_residue(s, "GLY", k + 1, test::glycine({20.0 * k, 0, 0}));
  s.b_factors.assign(8, 5.0F);
  s.b_factors[1] = 26.318945F;      // 1 Angstrom
  s.b_factors[5] = 4 * 26.318945F;  // 2 Angstrom
  EXPECT_NEAR(b_factor_amplitude(s, {}).value, 1.5, 1e-6);
  EXPECT_EQ(choose_amplitude("2.5", s, {}).value, 2.5);
  EXPECT_EQ(test::error_text<OptionError>([&] { choose_amplitude("0", s, {}); }),
            "amplitude: expected a number above 0 (Angstrom), bfactors, or a file with models of "
            "the molecule; found 0");
  s.b_factors.clear();
  EXPECT_TRUE(test::error_text<OptionError>([&] {
                b_factor_amplitude(s, {});
              }).starts_with("amplitude bfactors: "));
}

}  // namespace steric_table_test
}  // namespace pliant
