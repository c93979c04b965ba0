// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/select_part.hpp"

#include "pliant/model/prepare/additives.hpp"
#include "pliant/model/prepare/edit_structure.hpp"
#include "pliant/model/prepare/largest_molecule.hpp"
#include "pliant/model/prepare/prepare.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/crystal_additives.hpp"
#include "pliant/molecule/read/read.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::select_part_test {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

/// Two glycines, a silicon that the file bonds to the first O, a water.
constexpr std::string_view text =
    "ATOM      1  N   GLY A   1       0.000   0.000   0.000  1.00 10.00           N\n"
    "ATOM      2  CA  GLY A   1       1.450   0.000   0.000  1.00 11.00           C\n"
    "ATOM      3  C   GLY A   1       2.000   1.420   0.000  1.00 12.00           C\n"
    "ATOM      4  O   GLY A   1       1.250   2.390   0.000  1.00 13.00           O\n"
    "ATOM      5  N   GLY A   2       3.330   1.540   0.000  1.00 14.00           N\n"
    "TER\n"
    "HETATM    6 SI   LIG B   1       1.250   4.020   0.000  1.00 15.00          SI\n"
    "HETATM    7  O   HOH B   2       9.000   9.000   9.000  1.00 16.00           O\n"
    "CONECT    4    6\n";

Structure whole() {
  Structure structure = read_structure(SourceText{"x.pdb", text});
  perceive_bonds(structure, {});
  return structure;
}

const std::string cut = "warning: select: 1 bond to an atom that is left out vanishes";

struct Messages {
  std::vector<std::string> lines;
  Log log() {
    return {[this](Severity severity, std::string_view line) {
      lines.push_back((severity == Severity::warning ? "warning: " : "note: ") + std::string(line));
    }};
  }
};

TEST(SelectPart, TakesAtomsWithAllTheirColumns) {
  Messages messages;
  const Structure part = select_part(whole(), "protein", messages.log());
  EXPECT_EQ(part.atoms.names, (std::vector<std::string>{"N", "CA", "C", "O", "N"}));
  EXPECT_EQ(part.atoms.serials, (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(part.b_factors, (std::vector<float>{10, 11, 12, 13, 14}));
  EXPECT_EQ(part.positions[4], (Vec3{3.33, 1.54, 0.0}));
  EXPECT_EQ(part.bonds.size(), 4U);
  EXPECT_EQ(part.source, "x.pdb");
  EXPECT_EQ(messages.lines, (std::vector<std::string>{"note: select: 5 of 7 atoms", cut}));
}

TEST(SelectPart, NumbersBondsAnew) {
  Messages messages;
  const Structure part = select_part(whole(), "element O Si", messages.log());
  ASSERT_EQ(part.bonds.size(), 1U);
  EXPECT_EQ(part.bonds[0], (Bond{0, 1, BondOrigin::file, 0}));
  EXPECT_EQ(messages.lines, (std::vector<std::string>{"note: select: 3 of 7 atoms", cut}));
}

TEST(SelectPart, OfAllIsTheSame) {
  Messages messages;
  const Structure all = whole(), part = select_part(all, "all", messages.log());
  EXPECT_EQ(part.atoms.residues, all.atoms.residues);
  EXPECT_EQ(part.bonds, all.bonds);
  EXPECT_EQ(part.chain_end, all.chain_end);
  EXPECT_EQ(messages.lines, std::vector<std::string>{"note: select: 7 of 7 atoms"});
}

TEST(SelectPart, OfNothingIsRefused) {
  EXPECT_ERROR(OptionError, "select: selection \"nucleic\" names no atom",
               select_part(whole(), "nucleic"));
  EXPECT_THROW(select_part(whole(), "name"), OptionError);
}

Structure water_and_glycine() {
  Structure s;
  test::add_residue(s, "HOH", 1, test::water({0, 9, 0}), "W");
  test::add_residue(s, "GLY", 1, test::glycine({0, 0, 0}));
  perceive_bonds(s);
  return s;
}

TEST(EditStructure, WithoutAtomsBondsAndResiduesFollow) {
  const EditedStructure edited =
      without_atoms(water_and_glycine(), {true, true, true, false, false, false, false});
  const Structure& s = edited.structure;
  EXPECT_EQ(edited.origin, (std::vector<std::uint32_t>{3, 4, 5, 6}));
  ASSERT_EQ(s.atoms.residues.size(), 1U);
  EXPECT_EQ(s.atoms.residues[0].name, "GLY");
  EXPECT_EQ(s.atoms.residue_of, (std::vector<std::uint32_t>{0, 0, 0, 0}));
  EXPECT_EQ(test::bonds_text(s), "0-1 1-2 2-3 residue");
}

TEST(EditStructure, NewAtomsAreTheLastOfTheirResidue) {
  const Structure before = water_and_glycine();
  const EditedStructure edited =
      with_atoms(before, {{0, "X", 1, {1, 2, 3}}, {3, "H", 1, {0, 1, 0}}});
  const Structure& s = edited.structure;
  ASSERT_EQ(s.size(), before.size() + 2);
  EXPECT_EQ(s.atoms.names[3], "X");
  EXPECT_EQ(s.atoms.names.back(), "H");
  EXPECT_EQ(s.positions[3], (Vec3{1, 2, 3}));
  EXPECT_EQ(edited.origin[3], no_atom);
  EXPECT_EQ(edited.origin[4], 3U);
  EXPECT_EQ(s.bonds.size(), before.bonds.size() + 2);
  for (std::size_t k = 0; k < s.size(); ++k)
    EXPECT_EQ(s.atoms.serials[k], static_cast<std::int64_t>(k) + 1);
}

Structure salt() {
  const std::string text =
      "sodium formate\n\n\n  6  3  0  0  0  0  0  0  0  0999 V2000\n"
      "    9.0000    0.0000    0.0000 Na  0  3\n"
      "    0.0000    0.0000    0.0000 C   0  0\n"
      "    1.2000    0.5000    0.1000 O   0  5\n"
      "   -1.2000    0.5000    0.0000 O   0  0\n"
      "    0.0000   -1.1000    0.0000 H   0  0\n"
      "    0.0000    9.0000    0.0000 O   0  0\n"
      "  2  3  1  0\n  2  4  2  0\n  2  5  1  0\nM  END\n";
  return read_structure(SourceText{"salt.sdf", text});
}

TEST(LargestMolecule, IsKeptWithItsBondsAndCharges) {
  std::vector<std::string> notes;
  const Log log{[&](Severity, std::string_view text) { notes.emplace_back(text); }};
  const Structure kept = largest_molecule(salt(), log);
  EXPECT_EQ(kept.size(), 4u);
  EXPECT_EQ(kept.bonds.size(), 3u);
  EXPECT_EQ(kept.charges, (std::vector<std::int8_t>{0, -1, 0, 0}));
  EXPECT_EQ(notes, std::vector<std::string>{"the largest of 3 molecules is kept: 4 of 6 atoms"});
}

TEST(LargestMolecule, LeavesOtherFormatsAlone) {
  Structure crystal = salt();
  crystal.format = "xyz";
  EXPECT_EQ(largest_molecule(crystal).size(), 6u);
}

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
  EXPECT_ERROR(
      OptionError,
      "keep: expected all or names of additives such as GOL or SO4, found \"DNS\" (did you "
      "mean DMS?)",
      find_additives(s, {"DNS"}));
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

}  // namespace pliant::select_part_test
