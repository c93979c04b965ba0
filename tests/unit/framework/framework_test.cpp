// SPDX-License-Identifier: MIT
#include "pliant/framework/framework.hpp"

#include "pliant/framework/fingerprint.hpp"
#include "pliant/framework/joint_names.hpp"
#include "pliant/framework/limits.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "support/test.hpp"

namespace pliant::framework_test {

std::shared_ptr<const AtomTable> three_atoms() {
  return std::make_shared<AtomTable>(
      AtomTable{{"N", "CA", "C"}, {7, 6, 6}, {0, 0, 0}, {{"LYS", 12, ' ', "A"}}, {1, 2, 5}});
}

/// A path of three joints, to be spoiled.
FrameworkParts path() {
  return {.joint_count = 3, .bars = {{0, 1}, {2, 1}}, .rest_lengths = {1.5, 2.5}};
}

template <class Spoil>
std::string refusal(Spoil spoil) {
  FrameworkParts parts = path();
  spoil(parts);
  return test::error_text<InputError>([&] { Framework(std::move(parts)); });
}

TEST(Framework, KeepsWhatItIsGiven) {
  FrameworkParts parts = path();
  parts.masses = {2, 4, 8};
  parts.pinned = {1, 1};
  const Framework framework(std::move(parts));
  EXPECT_EQ(framework.joint_count(), 3u);
  EXPECT_EQ(framework.bar_count(), 2u);
  EXPECT_EQ(framework.bars()[1], (Bar{2, 1}));
  EXPECT_EQ(framework.rest_lengths()[1], 2.5);
  EXPECT_EQ(framework.inverse_masses()[0], 0.5);
  EXPECT_EQ(framework.inverse_masses()[2], 0.125);
  EXPECT_TRUE(framework.is_pinned(1));
  EXPECT_FALSE(framework.is_pinned(0));
  EXPECT_EQ(framework.pinned_count(), 1u);
  EXPECT_EQ(framework.merged_bar_count(), 0u);
}

TEST(Framework, NeighboursComeInTheOrderOfTheBars) {
  FrameworkParts parts{.joint_count = 5, .bars = {{3, 1}, {1, 0}, {2, 1}, {0, 3}}};
  parts.rest_lengths.assign(4, 1.0);
  const Framework framework(std::move(parts));
  const auto around = framework.neighbours(1);
  ASSERT_EQ(around.size(), 3u);
  const Joint joints[] = {3, 0, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(around[k].joint, joints[k]);
    EXPECT_EQ(around[k].bar, k);
  }
  EXPECT_TRUE(framework.neighbours(4).empty());
}

TEST(Framework, NothingAndOneJointAreFrameworks) {
  EXPECT_EQ(Framework({}).bar_count(), 0u);
  EXPECT_EQ(Framework({.joint_count = 1}).neighbours(0).size(), 0u);
}

TEST(Framework, MergesEqualBarsAndKeepsTheFirst) {
  const Framework framework(
      {.joint_count = 3, .bars = {{0, 1}, {1, 2}, {1, 0}, {0, 1}}, .rest_lengths = {1, 2, 1, 1}});
  EXPECT_EQ(framework.bar_count(), 2u);
  EXPECT_EQ(framework.merged_bar_count(), 2u);
  EXPECT_EQ(framework.bars()[0], (Bar{0, 1}));
  EXPECT_EQ(framework.bars()[1], (Bar{1, 2}));
  EXPECT_EQ(framework.rest_lengths()[1], 2.0);
  EXPECT_EQ(framework.neighbours(0).size(), 1u);
  EXPECT_EQ(framework.neighbours(1)[1].bar, 1u);
}

struct Refused {
  const char* text;
  std::function<void(FrameworkParts&)> spoil;
};

/// three_atoms(), spoiled.
template <class Spoil>
auto atoms_with(Spoil spoil) {
  auto atoms = std::make_shared<AtomTable>(*three_atoms());
  spoil(*atoms);
  return [atoms](FrameworkParts& parts) { parts.atoms = atoms; };
}

TEST(Framework, RefusesWhatIsNone) {
  const Refused cases[] = {
      {"bar 0 - 1 is given twice, with rest lengths 1.5 and 1.25 Angstrom",
       [](auto& p) {
         p.bars.push_back({1, 0}), p.rest_lengths.push_back(1.25);
       }},
      {"bar N(1) - CA(2) is given twice, with rest lengths 1.5 and 1.5 Angstrom",
       [](auto& p) {
         p.atoms = three_atoms();
         p.bars.push_back({0, 1}), p.rest_lengths.push_back(1.5000000000000002);
       }},
      {"bar 1 joins joint 2 to itself",
       [](auto& p) {
         p.bars[1] = {2, 2};
       }},
      {"bar 1 joins joints 2 and 3 but there are 3 joints",
       [](auto& p) {
         p.bars[1] = {2, 3};
       }},
      {"bar 0 joins joints 4294967295 and 0 but there are 3 joints",
       [](auto& p) {
         p.bars[0] = {4294967295u, 0};
       }},
      {"pinned joint 3 of 3 does not exist", [](auto& p) { p.pinned = {3}; }},
      {"mass of C(5) is 0: must be from 1e-150 to 1e150 u",
       [](auto& p) {
         p.atoms = three_atoms(), p.masses = {1, 1, 0};
       }},
      {"framework: 2 bars but 1 rest lengths", [](auto& p) { p.rest_lengths.pop_back(); }},
      {"framework: 3 joints but 2 masses",
       [](auto& p) {
         p.masses = {1, 1};
       }},
      {"framework: 4 joints but 3 atom names",
       [](auto& p) { p.joint_count = 4, p.atoms = three_atoms(); }},
      {"framework: 4294967295 joints, but fewer than 2^32 - 1 can be held",
       [](auto& p) { p = {.joint_count = std::numeric_limits<std::uint32_t>::max()}; }},
      {"atom table: 3 names but 2 elements", atoms_with([](auto& a) { a.elements.pop_back(); })},
      {"atom table: 3 names but 4 residue indices",
       atoms_with([](auto& a) { a.residue_of.push_back(0); })},
      {"atom table: 3 names but 0 serials", atoms_with([](auto& a) { a.serials.clear(); })},
      {"atom table: atom 1 is in residue 1 of 1", atoms_with([](auto& a) { a.residue_of[1] = 1; })},
  };
  for (const auto& [text, spoil] : cases) EXPECT_EQ(refusal(spoil), text);
}

TEST(Framework, RefusesLengthsAndMassesThatAreNone) {
  const auto length = [](double value) {
    return refusal([&](auto& parts) { parts.rest_lengths[1] = value; });
  };
  const std::pair<double, std::string> none[] = {
      {0, "0"},           {-12, "-12"},           {std::nan(""), "nan"}, {HUGE_VAL, "inf"},
      {1e-310, "1e-310"}, {9.9e-151, "9.9e-151"}, {1.1e150, "1.1e+150"}};
  for (const auto& [value, text] : none) {
    EXPECT_EQ(length(value),
              "bar 2 - 1 has rest length " + text + ": must be from 1e-150 to 1e150 Angstrom");
    EXPECT_EQ(refusal([&](auto& parts) {
                parts.masses = {1, value, 1};
              }),
              "mass of joint 1 is " + text + ": must be from 1e-150 to 1e150 u");
  }
  for (double value : {1e-150, 1e150}) EXPECT_EQ(length(value), "");
}

TEST(Framework, LabelsJointsAndBars) {
  const Framework plain(path());
  EXPECT_EQ(plain.label(Joint{2}), "joint 2");
  EXPECT_EQ(plain.label(Bar{2, 1}), "2 - 1");
  FrameworkParts parts = path();
  parts.atoms = three_atoms();
  const Framework named(std::move(parts));
  EXPECT_EQ(named.label(Joint{1}), "CA(2)");
  EXPECT_EQ(named.label(Bar{0, 2}), "N(1) - C(5)");
  EXPECT_EQ(named.atoms()->size(), 3u);
}

TEST(State, BeginsAtRest) {
  const State state({{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(state.previous, state.positions);
  EXPECT_EQ(state.step, 0);
  EXPECT_EQ(state.time, 0.0);
}

TEST(AtomTable, LabelsTellResiduesApart) {
  const AtomTable atoms{{"CA", "CA", "O", "O"},
                        {6, 6, 8, 8},
                        {0, 1, 2, 3},
                        {{"LYS", 12, ' ', "A"},
                         {"LYS", 12, 'B', "A"},
                         {"HOH", -3, ' ', ""},
                         {"A\x1b", 1, ' ', "\xff"}},
                        {1, 2, 3, 4}};
  EXPECT_EQ(atoms.label(0), "A:LYS12:CA");
  EXPECT_EQ(atoms.label(1), "A:LYS12B:CA");
  EXPECT_EQ(atoms.label(2), "HOH-3:O");
  EXPECT_EQ(atoms.label(3), "\\xff:A\\x1b1:O");
}

TEST(AtomTable, LabelsOfAMoleculeAreNameAndSerialOfAGraphNames) {
  const AtomTable molecule{{"C1", "\x07"}, {6, 0}, {0, 0}, {{"UNK", 1, ' ', ""}}, {4, 9}};
  EXPECT_EQ(molecule.label(0), "C1(4)");
  EXPECT_EQ(molecule.label(1), "\\x07(9)");
  EXPECT_EQ((AtomTable{{"a", "b"}, {0, 0}, {0, 0}, {{}}, {1, 2}}).label(1), "b");
}

TEST(Framework, KeepsDrawnPositionsThatFitItsBars) {
  FrameworkParts parts{.joint_count = 2, .bars = {{0, 1}}, .rest_lengths = {2.0}};
  EXPECT_TRUE(Framework(parts).drawn().empty());
  parts.drawn = {{1, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(Framework(parts).drawn()[1], (Vec3{3, 0, 0}));
  parts.drawn[1].x = 4.0;
  EXPECT_ERROR(InputError, "bar 0 - 1 is drawn 3 long: its rest length is 2 Angstrom",
               Framework{parts});
  parts.drawn.pop_back();
  EXPECT_ERROR(InputError, "framework: 2 joints but 1 drawn positions", Framework{parts});
}

TEST(Limit, ItsExcessIsSigned) {
  const Limit limit{.a = 0, .b = 1, .least = 2.0, .most = 3.0};
  EXPECT_EQ(excess(limit, 3.5), 0.5);
  EXPECT_EQ(excess(limit, 1.5), -0.5);
  EXPECT_EQ(excess(limit, 2.0), 0.0);
  EXPECT_EQ(excess(limit, 3.0), 0.0);
}

TEST(Limit, KindsHaveNames) {
  for (const LimitKindEntry& row : limit_kinds()) EXPECT_EQ(find_limit_kind(row.name), row.kind);
  EXPECT_THROW(find_limit_kind("cable"), OptionError);
}

TEST(Limit, WhatCannotBeIsRefused) {
  const std::pair<const char*, Limit> cases[] = {
      {"", {.a = 0, .b = 2, .most = 1.0}},
      {"limit 0 joins joints 0 and 9 but there are 3 joints", {.a = 0, .b = 9}},
      {"limit 0 joins joint 2 to itself", {.a = 2, .b = 2}},
      {"limit 1 - 0 has a bar already, of 1.5 Angstrom", {.a = 1, .b = 0}},
      {"limit 0 - 2 has least distance 2 above most 1 Angstrom",
       {.a = 0, .b = 2, .least = 2.0, .most = 1.0}},
      {"limit 0 - 2 has least distance -1: must be from 0 to 1e150 Angstrom",
       {.a = 0, .b = 2, .least = -1.0}},
      {"limit 0 - 2 has most distance nan: must be above 0, up to 1e150 Angstrom or infinite",
       {.a = 0, .b = 2, .most = std::nan("")}},
      {"limit 0 - 2 has energy nan: must be finite", {.a = 0, .b = 2, .energy = std::nan("")}},
  };
  for (const auto& [text, limit] : cases)
    EXPECT_EQ(refusal([&](auto& parts) { parts.limits = {limit}; }), text);
}

TEST(Limit, JointsKnowTheirLimits) {
  const Framework framework(
      {.joint_count = 4, .limits = {{.a = 0, .b = 2}, {.a = 3, .b = 0}, {.a = 2, .b = 3}}});
  const auto at = framework.limits_at(0);
  EXPECT_EQ(std::vector<LimitIndex>(at.begin(), at.end()), (std::vector<LimitIndex>{0, 1}));
  EXPECT_TRUE(framework.limits_at(1).empty());
}

TEST(JointNames, AreIndicesWhereThereAreNone) {
  const Framework framework = framework_of(chain(3));
  const JointNames names(framework);
  EXPECT_EQ(names.find("2", {"f.txt", 1}), 2u);
  EXPECT_EQ(names.word_for(1, "force file"), "1");
  EXPECT_ERROR(InputError, "f.txt:1: joint: no joint is named \"3\"",
               names.find("3", {"f.txt", 1}));
  EXPECT_ERROR(InputError, "f.txt:1: joint: no joint is named \"-0x1\"",
               names.find("-0x1", {"f.txt", 1}));
}

const AtomTable two_atoms{{"C", "A1"}, {6, 0}, {0, 0}, {{"LIG", 1, ' ', "A"}}, {1, 2}};
const std::vector<Vec3> places{{1.0, 2.0, 3.0}, {-0.5, 0.0, 1e-300}};

/// The offset basis, and 1.0 as the bytes 00 00 00 00 00 00 f0 3f, worked out apart with Python's
/// whole numbers.
TEST(Fingerprint, IsFnv1aOfTheBytes) {
  EXPECT_EQ(fingerprint(std::span<const Vec3>{}), 0xcbf29ce484222325u);
  EXPECT_EQ(fingerprint_text(fingerprint(std::vector<Vec3>{{1.0, 0.0, 0.0}})), "bd85f5df2322cbb8");
}

TEST(Fingerprint, IsOfAnotherStructureWhereAnythingDiffers) {
  const auto changed = [](auto change) {
    AtomTable atoms = two_atoms;
    std::vector<Vec3> at = places;
    change(atoms, at);
    return fingerprint(atoms, at) != fingerprint(two_atoms, places);
  };
  EXPECT_TRUE(changed([](auto& atoms, auto&) { atoms.names = {"CA", "1"}; }));
  EXPECT_TRUE(changed([](auto& atoms, auto&) { atoms.elements[0] = 7; }));
  EXPECT_TRUE(changed([](auto& atoms, auto&) { atoms.residues[0].name = "ALA"; }));
  EXPECT_TRUE(changed([](auto&, auto& at) { at[1].y = -0.0; }));
  EXPECT_FALSE(changed([](auto& atoms, auto&) { atoms.residues[0].chain = "B"; }));
}

}  // namespace pliant::framework_test
