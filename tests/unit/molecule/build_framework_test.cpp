// SPDX-License-Identifier: MIT
#include "pliant/molecule/build_framework.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/error.hpp"
#include "support/error_text.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::build_framework_test {

using namespace test;
namespace build_framework_test {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

/// Bonds between consecutive atoms, and the last with the first where `closed`.
Structure chain_of(const std::vector<std::pair<const char*, Vec3>>& atoms, bool closed = false) {
  Structure s = molecule(atoms);
  s.source = "some.xyz";
  for (std::uint32_t i = 0; i + 1 < s.size(); ++i) s.bonds.push_back({i, i + 1});
  if (closed) s.bonds.push_back({0, static_cast<std::uint32_t>(s.size()) - 1});
  return s;
}

std::vector<std::string> bar_texts(const Framework& framework) {
  std::vector<std::string> texts;
  for (Bar bar : framework.bars())
    texts.push_back(std::to_string(bar.a) + "-" + std::to_string(bar.b));
  return texts;
}

template <class Exception>
std::string refusal(const Structure& s, const BuildOptions& options = {}) {
  return test::error_text<Exception>([&] { build_framework(s, options); });
}

TEST(BuildFramework, MakesABarOfEachBondWithItsLengthAndMasses) {
  const Framework f =
      build_framework(chain_of({{"C", {}}, {"O", {1.4, 0, 0}}, {"H", {1.4, 1, 0}}}));
  EXPECT_THAT(bar_texts(f), ElementsAre("0-1", "1-2"));
  EXPECT_THAT(f.rest_lengths(), ElementsAre(1.4, 1.0));
  EXPECT_THAT(f.inverse_masses(),
              ElementsAre(DoubleNear(1 / 12.011, 1e-6), DoubleNear(1 / 15.999, 1e-6),
                          DoubleNear(1 / 1.008, 1e-6)));
  ASSERT_NE(f.atoms(), nullptr);
  EXPECT_EQ(f.label(f.bars()[0]), "C(1) - O(2)");
}

TEST(BuildFramework, CanLeaveMassesOut) {
  BuildOptions options;
  options.use_masses = false;
  const Framework f = build_framework(chain_of({{"C", {}}, {"O", {1.4, 0, 0}}}), options);
  EXPECT_THAT(f.inverse_masses(), ElementsAre(1.0, 1.0));
}

TEST(BuildFramework, PutsABarAcrossEachAngle) {
  BuildOptions options;
  options.bars = BarKind::angles;
  const Framework f = build_framework(
      chain_of({{"C", {}}, {"C", {1.5, 0, 0}}, {"C", {1.5, 1.5, 0}}, {"C", {3, 1.5, 0}}}), options);
  EXPECT_THAT(bar_texts(f), ElementsAre("0-1", "1-2", "2-3", "0-2", "1-3"));
  EXPECT_DOUBLE_EQ(f.rest_lengths()[3], std::sqrt(4.5));
}

TEST(BuildFramework, PutsOneBarAcrossARingsTwoAngles) {
  BuildOptions options;
  options.bars = BarKind::angles;
  const std::vector<std::pair<const char*, Vec3>> square{
      {"C", {}}, {"C", {1.5, 0, 0}}, {"C", {1.5, 1.5, 0}}, {"C", {0, 1.5, 0}}};
  const Framework f = build_framework(chain_of(square, true), options);
  EXPECT_THAT(bar_texts(f), ElementsAre("0-1", "1-2", "2-3", "0-3", "0-2", "1-3"));
  EXPECT_EQ(f.merged_bar_count(), 0U);
  const Framework triangle = build_framework(
      chain_of({{"C", {}}, {"C", {1.5, 0, 0}}, {"C", {0.75, 1.3, 0}}}, true), options);
  EXPECT_THAT(bar_texts(triangle), ElementsAre("0-1", "1-2", "0-2"));
}

TEST(BuildFramework, MergesABondGivenTwice) {
  Structure s = chain_of({{"C", {}}, {"C", {1.5, 0, 0}}});
  s.bonds.push_back({1, 0});
  const Framework f = build_framework(s);
  EXPECT_EQ(f.bar_count(), 1U);
  EXPECT_EQ(f.merged_bar_count(), 1U);
  EXPECT_EQ(build_framework(s, {.bars = BarKind::angles}).bar_count(), 1U);
}

TEST(BuildFramework, TakesNoBondsAndNoAtoms) {
  EXPECT_EQ(build_framework(molecule({{"C", {}}})).bar_count(), 0U);
  EXPECT_EQ(build_framework({}).joint_count(), 0U);
}

TEST(BuildFramework, TakesLengthsFromTheTable) {
  BuildOptions options;
  options.lengths = LengthSource::table;
  std::string message;
  options.log.function = [&](Severity, std::string_view text) { message = text; };
  Structure s = chain_of({{"C", {}}, {"C", {1, 0, 0}}, {"C", {2, 0, 0}}, {"C", {3, 0, 0}}});
  s.bonds[0].order = 3;
  s.bonds[1].order = 1;
  s.bonds.push_back({0, 3, BondOrigin::link, 1});
  const Framework f = build_framework(s, options);
  EXPECT_THAT(f.rest_lengths(), ElementsAre(1.19, 1.53, DoubleNear(1.52, 1e-12), 1.53));
  EXPECT_EQ(message,
            "rest lengths of 1 of 4 bars are sums of covalent radii: no standard length is known");
}

TEST(BuildFramework, GivesPeptideBondsTheirLength) {
  BuildOptions options;
  options.lengths = LengthSource::table;
  Structure s = chain_of({{"C", {}}, {"N", {1, 0, 0}}, {"H", {2, 0, 0}}});
  s.bonds[0] = {0, 1, BondOrigin::link, 1};
  EXPECT_THAT(build_framework(s, options).rest_lengths(), ElementsAre(1.33, 1.01));
}

TEST(BuildFramework, RefusesTableLengthsItCannotKnow) {
  BuildOptions options;
  options.lengths = LengthSource::table;
  EXPECT_EQ(refusal<InputError>(chain_of({{"C", {}}, {"X", {1, 0, 0}}}), options),
            "some.xyz: bar C(1) - X(2) has no standard length: element X has no covalent radius");
  options.bars = BarKind::angles;
  EXPECT_EQ(refusal<OptionError>(chain_of({{"C", {}}, {"C", {1, 0, 0}}}), options),
            "lengths \"table\" is for bars \"bonds\" only: bars across angles have no standard "
            "lengths");
}

TEST(BuildFramework, RefusesBarsOfNoLengthNamingBothAtoms) {
  EXPECT_EQ(refusal<InputError>(chain_of({{"C", {1, 2, 3}}, {"O", {1, 2, 3}}})),
            "some.xyz: bar C(1) - O(2) has length 0: both atoms are at (1.000, 2.000, 3.000)");
  BuildOptions options;
  options.bars = BarKind::angles;
  EXPECT_EQ(refusal<InputError>(chain_of({{"H", {}}, {"C", {1, 0, 0}}, {"O", {}}}), options),
            "some.xyz: bar H(1) - O(3) has length 0: both atoms are at (0.000, 0.000, 0.000)");
}

TEST(BuildFramework, RefusesBondsToAtomsThatAreNotThere) {
  Structure s = chain_of({{"C", {}}, {"O", {1, 0, 0}}});
  s.bonds.push_back({1, 7});
  EXPECT_EQ(refusal<InputError>(s), "some.xyz: a bond names atom 7 of 2 (counted from 0)");
}

TEST(BuildFramework, RefusesAnglesAtAStar) {
  Structure s = molecule({{"C", {}}});
  s.atoms.serials.back() = 1;
  for (std::uint32_t i = 1; i <= 65; ++i) {
    add_residue(s, "X", i, {{"H", "H", {0.1 * i, 0, 0}}});
    s.bonds.push_back({0, i});
  }
  BuildOptions options;
  options.bars = BarKind::angles;
  EXPECT_EQ(refusal<InputError>(s, options),
            "atom UNK1:C has 65 bonds: bars across angles are for at most 64");
}

TEST(BuildFramework, PinsSelectedAtoms) {
  BuildOptions options;
  options.pin = "element O or index 0";
  const Framework f =
      build_framework(chain_of({{"C", {}}, {"O", {1.4, 0, 0}}, {"H", {1.4, 1, 0}}}), options);
  EXPECT_TRUE(f.is_pinned(0));
  EXPECT_TRUE(f.is_pinned(1));
  EXPECT_FALSE(f.is_pinned(2));
}

TEST(BuildFramework, RefusesASelectionOfNothing) {
  BuildOptions options;
  options.pin = "name CA";
  EXPECT_EQ(refusal<OptionError>(chain_of({{"C", {}}, {"O", {1.4, 0, 0}}}), options),
            "pin: selection \"name CA\" names no atom");
}

}  // namespace build_framework_test
}  // namespace pliant::build_framework_test
