// SPDX-License-Identifier: MIT
#include "pliant/molecule/build_framework.hpp"

#include "pliant/molecule/bars_file.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::build_framework_test {

using namespace test;
using testing::DoubleNear;
using testing::ElementsAre;

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
  const Framework f =
      build_framework(chain_of({{"C", {}}, {"O", {1.4, 0, 0}}}), {.use_masses = false});
  EXPECT_THAT(f.inverse_masses(), ElementsAre(1.0, 1.0));
}

TEST(BuildFramework, PutsABarAcrossEachAngle) {
  const Framework f = build_framework(
      chain_of({{"C", {}}, {"C", {1.5, 0, 0}}, {"C", {1.5, 1.5, 0}}, {"C", {3, 1.5, 0}}}),
      {.bars = BarKind::angles});
  EXPECT_THAT(bar_texts(f), ElementsAre("0-1", "1-2", "2-3", "0-2", "1-3"));
  EXPECT_DOUBLE_EQ(f.rest_lengths()[3], std::sqrt(4.5));
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

TEST(BuildFramework, RefusesBarsOfNoLengthNamingBothAtoms) {
  EXPECT_EQ(refusal<InputError>(chain_of({{"C", {1, 2, 3}}, {"O", {1, 2, 3}}})),
            "some.xyz: bar C(1) - O(2) has length 0: both atoms are at (1.000, 2.000, 3.000)");
  EXPECT_EQ(refusal<InputError>(chain_of({{"H", {}}, {"C", {1, 0, 0}}, {"O", {}}}),
                                {.bars = BarKind::angles}),
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
  EXPECT_EQ(refusal<InputError>(s, {.bars = BarKind::angles}),
            "atom UNK1:C has 65 bonds: bars across angles are for at most 64");
}

TEST(BuildFramework, PinsSelectedAtoms) {
  const Structure s = chain_of({{"C", {}}, {"O", {1.4, 0, 0}}, {"H", {1.4, 1, 0}}});
  const Framework f = build_framework(s, {.pin = "element O or index 0"});
  EXPECT_TRUE(f.is_pinned(0));
  EXPECT_TRUE(f.is_pinned(1));
  EXPECT_FALSE(f.is_pinned(2));
  EXPECT_EQ(refusal<OptionError>(s, {.pin = "name CA"}),
            "pin: selection \"name CA\" names no atom");
}

/// Carbons along x, 1.5 Angstrom apart, and an oxygen at the end; a bond between neighbours.
Structure chain() {
  return chain_of({{"C", {}}, {"C", {1.5, 0, 0}}, {"C", {3, 0, 0}}, {"O", {4.5, 0, 0}}});
}

Framework joints_of(const Structure& s) {
  return Framework({.joint_count = s.size(), .atoms = std::make_shared<const AtomTable>(s.atoms)});
}

BarsFile parse(const std::string& lines, const Framework& joints = joints_of(chain())) {
  return parse_bars_file({"b.txt", "pliant-bars 1\n" + lines}, joints);
}

Framework framework_of(const Structure& s, const std::string& lines,
                       const std::filesystem::path& path) {
  std::ofstream(path) << "pliant-bars 1\n" << lines;
  BuildOptions options;
  take_bars(path.string(), s, options);
  return build_framework(s, options);
}

Framework framework_of(const Structure& s, const std::string& lines) {
  const test::TempDirectory directory;
  return framework_of(s, lines, directory / "bars.txt");
}

TEST(BarsFile, KindsOfJointAreElementsUnlessSaid) {
  const BarsFile file = parse("kind 1 Q\nkind 2 none\nsterics Q C 3\nsterics C C 2.5\nown 0 3 1\n");
  ASSERT_TRUE(file.sterics);
  const auto& [sterics, names] = *file.sterics;
  EXPECT_EQ(names, (std::vector<std::string>{"C", "Q", ""}));
  EXPECT_EQ(sterics.kinds, (std::vector<std::uint16_t>{0, 1, 2, 2}));
  EXPECT_EQ(sterics.least, (std::vector<double>{2.5, 3, 0, 3, 0, 0, 0, 0, 0}));
  EXPECT_EQ(sterics.own, (std::vector<OwnDistance>{{0, 3, 1.0}}));
  EXPECT_EQ(sterics.excluded_bonds, 3);
  check(sterics, 4);
}

TEST(BarsFile, IsReadBackToTheSameBits) {
  const std::string lines =
      "bars angles\nbar 0 O 4.25\nbar 1 O\nlimit 0 1 0.1 inf given 0\n"
      "limit 0 2 1e-300 3.0000000000000004 torsion 0.30000000000000004 7\n"
      "sterics C C 2.5\nsterics C Q 0.1\nsterics Q Q 0\n"
      "kind 1 Q\nkind 2 none\nown O 0 1.7\nbonds_apart 4\n";
  const Framework joints = joints_of(chain());
  EXPECT_EQ(write_bars_file(parse(lines), joints), "pliant-bars 1\n" + lines);
}

TEST(BarsFile, SaysWhatNoLineCanState) {
  BarsFile file = parse("sterics C C 2.5\n");
  file.sterics->sterics.units.assign(4, no_unit);
  EXPECT_ERROR(InputError, "bars file: no line can state units and bonds of sterics",
               write_bars_file(file, joints_of(chain())));
  file = parse("sterics C C 2.5\n");
  file.sterics->kind_names = {"a b", ""};
  EXPECT_ERROR(InputError,
               "bars file: expected names of the kinds of joint, ascending, the last empty",
               write_bars_file(file, joints_of(chain())));
}

TEST(TakeBars, PutsStatedBarsInThePlaceOfBonds) {
  const Framework f = framework_of(chain(), "bars bonds\nbar 2 1 1.75\nbar 0 3\n");
  EXPECT_EQ(std::vector(f.bars().begin(), f.bars().end()),
            (std::vector<Bar>{{0, 1}, {1, 2}, {2, 3}, {0, 3}}));
  EXPECT_EQ(std::vector(f.rest_lengths().begin(), f.rest_lengths().end()),
            (std::vector<double>{1.5, 1.75, 1.5, 4.5}));
  EXPECT_TRUE(f.drawn().empty());
  EXPECT_EQ(framework_of(chain(), "bars bonds\nbar 0 3\n").drawn().size(), 4u);
}

TEST(TakeBars, BuildsFrameworksWithLimitsAndSterics) {
  const Framework f = framework_of(chain(), "limit 0 3 1 2\nsterics C O 3\n");
  EXPECT_EQ(f.bar_count(), 0u);
  ASSERT_EQ(f.limits().size(), 1u);
  ASSERT_NE(f.sterics(), nullptr);
  EXPECT_EQ(f.sterics()->of_kinds(0, 3), 3.0);
  EXPECT_EQ(f.sterics()->of_kinds(0, 1), 0.0);
}

TEST(TakeBars, TakesNamesToo) {
  BuildOptions options;
  take_bars("angles", chain(), options);
  EXPECT_EQ(options.bars, BarKind::angles);
  EXPECT_ERROR(
      OptionError,
      "no kind of bars (or bars file) named \"bond\" (did you mean \"bonds\"?); known: bonds, "
      "angles, none",
      take_bars("bond", chain(), options));
}

TEST(TakeBars, NamesTheFileOfALimitThatABarForbids) {
  const test::TempDirectory directory;
  const auto path = directory / "bars.txt";
  EXPECT_ERROR(InputError, path.string() + ": limit C(1) - C(2) has a bar already, of 1.5 Angstrom",
               framework_of(chain(), "bars bonds\nlimit 0 1 1 2\n", path));
}

}  // namespace pliant::build_framework_test
