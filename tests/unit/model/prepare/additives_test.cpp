// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/additives.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "pliant/base/error.hpp"
#include "pliant/model/prepare/prepare.hpp"
#include "pliant/molecule/crystal_additives.hpp"
#include "support/error_text.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::additives_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<test::MadeAtom> dimethyl_sulfoxide(Vec3 at) {
  return {{"S", "S", at},
          {"O", "O", at + Vec3{1.5, 0, 0}},
          {"C1", "C", at + Vec3{-0.9, 1.5, 0}},
          {"C2", "C", at + Vec3{-0.9, -0.8, 1.3}}};
}

/// Glycine, DMS far from it, and a formate.
Structure crystal() {
  Structure s;
  test::add_residue(s, "GLY", 1, test::glycine({0, 0, 0}));
  test::add_residue(s, "DMS", 2, dimethyl_sulfoxide({20, 0, 0}));
  test::add_residue(s, "DMS", 3, dimethyl_sulfoxide({40, 0, 0}));
  test::add_residue(s, "FMT", 4, {{"C", "C", {60, 0, 0}}, {"O1", "O", {61.25, 0, 0}}});
  return s;
}

Structure bonded(Structure s) {
  s.source = "made.pdb";
  perceive_bonds(s);
  return s;
}

TEST(Additives, AreLeftOutBesideAPolymerAndSaid) {
  const Preparation ready = prepare(bonded(crystal()));
  EXPECT_EQ(ready.structure.atoms.residues.size(), 1U);
  const std::string said = "3 molecules of crystallisation: 2 DMS, 1 FMT (--keep all keeps them)";
  EXPECT_THAT(ready.left_out, ElementsAre(said));
  EXPECT_EQ(ready.steps[0], "left out: " + said);
}

TEST(Additives, StayWhereTheyAreKept) {
  const Structure s = bonded(crystal());
  EXPECT_THAT(find_additives(s, {"all"}).out, IsEmpty());
  EXPECT_THAT(find_additives(s, {"DMS"}).out, ElementsAre(3));
  EXPECT_EQ(prepare(s, {.keep = {"FMT", "DMS"}}).structure.atoms.residues.size(), 4U);
  EXPECT_EQ(test::error_text<OptionError>([&] { find_additives(s, {"DNS"}); }),
            "keep: expected all or names of additives such as GOL or SO4, found \"DNS\" (did you "
            "mean DMS?)");
}

TEST(Additives, AreMoleculesLikeOthersWithoutAPolymer) {
  Structure s;
  test::add_residue(s, "DMS", 2, dimethyl_sulfoxide({20, 0, 0}));
  EXPECT_THAT(find_additives(bonded(s), {}).out, IsEmpty());
}

TEST(Additives, AreNoneWhereTheyAreBonded) {
  Structure s = bonded(crystal());
  s.bonds.push_back({1, 6, BondOrigin::file, 1});   // CA of glycine and C1 of the first
  s.bonds.push_back({7, 11, BondOrigin::file, 1});  // the first and the second
  EXPECT_THAT(find_additives(s, {}).out, ElementsAre(3));
}

TEST(Additives, StayWhereTheyHoldAMetal) {
  Structure s = crystal();
  test::add_residue(s, "ZN", 5, {{"ZN", "Zn", {63.3, 0, 0}}});
  const Additives found = find_additives(bonded(s), {});
  EXPECT_THAT(found.out, ElementsAre(1, 2));
  EXPECT_THAT(found.at_metals, ElementsAre(3));
  EXPECT_THAT(prepare(bonded(s)).steps, Contains("kept at metals: A:FMT4"));
}

TEST(Additives, EachNameIsInTheTableOnce) {
  const auto names = crystal_additive_names();
  EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), names.size());
  EXPECT_THAT(names, Contains("GOL"));
  for (const std::string_view ligand : {"HEM", "NAG", "ATP", "GSH", "CLR", "BEN", "ZN", "CL"})
    EXPECT_THAT(names, ::testing::Not(Contains(ligand)));
}

}  // namespace
}  // namespace pliant::additives_test
