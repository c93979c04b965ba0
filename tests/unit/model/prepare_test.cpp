// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/prepare.hpp"

#include "pliant/model/prepare/hydrogen_places.hpp"
#include "pliant/model/prepare/survey.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::prepare_test {

using namespace test;
using testing::ElementsAre;

Structure with_bonds(Structure s) {
  s.source = "made.pdb";
  perceive_bonds(s);
  return s;
}

/// The ring and CB of histidine in a plane, without a backbone.
std::vector<MadeAtom> histidine() {
  return {{"CB", "C", {-1.5, 0.0, 0.0}}, {"CG", "C", {0.0, 0.0, 0.0}},
          {"ND1", "N", {0.8, 1.1, 0.0}}, {"CD2", "C", {0.8, -1.1, 0.0}},
          {"CE1", "C", {2.1, 0.7, 0.0}}, {"NE2", "N", {2.1, -0.65, 0.0}}};
}

/// Serine's end: two C and the O of a hydroxyl group.
std::vector<MadeAtom> hydroxyl() {
  return {
      {"CA", "C", {-1.2, 0.9, 0.0}}, {"CB", "C", {0.0, 0.0, 0.0}}, {"OG", "O", {1.4, 0.0, 0.0}}};
}

std::vector<std::string> hydrogens_of(const Structure& s) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.atoms.elements[i] == 1) names.push_back(s.atoms.names[i]);
  return names;
}

Vec3 position_of(const Structure& s, const std::string& name) {
  const auto at = std::find(s.atoms.names.begin(), s.atoms.names.end(), name);
  return s.positions.at(static_cast<std::size_t>(at - s.atoms.names.begin()));
}

double degrees(Vec3 one, Vec3 at, Vec3 other) {
  const Vec3 u = one - at, v = other - at;
  return std::acos(dot(u, v) / norm(u) / norm(v)) * 180.0 / std::numbers::pi;
}

TEST(Prepare, PlacesHistidinesHydrogenByForm) {
  Structure s;
  add_residue(s, "HIS", 7, histidine());
  s = with_bonds(s);
  EXPECT_THAT(hydrogens_of(prepare(s).structure), ElementsAre("HE2"));
  EXPECT_THAT(hydrogens_of(prepare(s, {.protonate = {"HIS7:HID"}}).structure), ElementsAre("HD1"));
  EXPECT_THAT(hydrogens_of(prepare(s, {.protonate = {"A:HIS7:HIP"}}).structure),
              ElementsAre("HD1", "HE2"));
  s.atoms.residues[0].name = "HSD";
  EXPECT_THAT(hydrogens_of(prepare(s).structure), ElementsAre("HD1"));
}

TEST(Prepare, TheHydrogenOfARingIsOnTheBisector) {
  Structure s;
  add_residue(s, "HIS", 7, histidine());
  const Structure ready = prepare(with_bonds(s)).structure;
  const Vec3 n = position_of(ready, "NE2"), h = position_of(ready, "HE2");
  EXPECT_NEAR(distance(n, h), 1.01, 1e-12);
  EXPECT_EQ(h.z, 0.0);
  EXPECT_NEAR(degrees(position_of(ready, "CE1"), n, h), degrees(position_of(ready, "CD2"), n, h),
              1e-9);
}

TEST(Prepare, AHydroxylGroupTurnsToAnAcceptor) {
  Structure s;
  add_residue(s, "SER", 3, hydroxyl());
  Structure alone = with_bonds(s);
  const Structure ready = prepare(alone).structure;
  const Vec3 o = position_of(ready, "OG"), h = position_of(ready, "HG");
  EXPECT_NEAR(distance(o, h), 0.96, 1e-12);
  EXPECT_NEAR(degrees(position_of(ready, "CB"), o, h), 109.5, 1e-9);
  // The acceptor lies where a torsion of 100 degrees points to.
  const Spin spin(alone.positions[0], alone.positions[1], alone.positions[2]);
  const Vec3 wanted = spin.at(0.96, tetrahedral_angle, 10);
  const Vec3 acceptor = wanted + (1.8 / 0.96) * (wanted - alone.positions[2]);
  add_residue(s, "GLY", 9, {{"O", "O", acceptor}}, "B");
  const Structure bound = prepare(with_bonds(s)).structure;
  EXPECT_NEAR(distance(position_of(bound, "HG"), wanted), 0.0, 1e-12);
}

TEST(Prepare, KeepsTheHydrogensOfTheFile) {
  Structure s;
  auto atoms = hydroxyl();
  atoms.push_back({"HG", "H", {1.7, -0.9, 0.0}});
  add_residue(s, "SER", 3, atoms);
  const Preparation ready = prepare(with_bonds(s));
  EXPECT_THAT(hydrogens_of(ready.structure), ElementsAre("HG"));
  EXPECT_EQ(position_of(ready.structure, "HG"), (Vec3{1.7, -0.9, 0.0}));
  EXPECT_THAT(ready.steps, ElementsAre("hydrogens of the file kept"));
}

TEST(Prepare, TakesWatersOutAndKeepsCountOfOrigins) {
  Structure s;
  add_residue(s, "HOH", 1, water({10, 0, 0}));
  add_residue(s, "SER", 3, hydroxyl());
  s = with_bonds(s);
  const Preparation ready = prepare(s);
  EXPECT_THAT(ready.origin, ElementsAre(3, 4, 5, no_atom));
  EXPECT_EQ(ready.structure.atoms.residues.size(), 1U);
  EXPECT_EQ(ready.steps[0], "1 water taken out");
  EXPECT_EQ(prepare(s, {.keep_waters = true}).structure.size(), 7U);
}

TEST(Prepare, TakesDummyAtomsOfAMembraneOut) {
  Structure s;
  add_residue(s, "SER", 3, hydroxyl());
  for (int number = 10; number < 13; ++number)
    add_residue(s, "DUM", number, {{"O", "O", {double(number), 5, 0}}});
  const Preparation ready = prepare(with_bonds(s));
  EXPECT_EQ(ready.structure.atoms.residues.size(), 1U);
  EXPECT_EQ(ready.steps[0], "3 dummy residues (DUM) taken out");
  Structure nothing;
  add_residue(nothing, "DUM", 1, {{"O", "O", {0, 0, 0}}});
  EXPECT_ERROR(InputError, "holds nothing but dummy atoms", prepare(nothing));
}

TEST(Prepare, TakesSeleniumAsSulphur) {
  Structure s;
  add_residue(s, "MSE", 4,
              {{"CG", "C", {0, 0, 0}}, {"SE", "Se", {1.95, 0, 0}}, {"CE", "C", {2.5, 1.87, 0}}});
  const Preparation ready = prepare(with_bonds(s));
  EXPECT_EQ(ready.structure.atoms.residues[0].name, "MET");
  EXPECT_EQ(ready.structure.atoms.names[1], "SD");
  EXPECT_EQ(ready.structure.atoms.elements[1], 16);
  EXPECT_EQ(ready.structure.bonds.size(), 2U);
  EXPECT_EQ(ready.steps[0], "1 residue MSE taken as MET");
  EXPECT_THAT(ready.missing,
              ElementsAre("side chains: 1 residue lacks atoms: A:MET4 (CB); --fill-side-chains "
                          "builds them"));
}

/// Twelve glycines far from each other, each with one B factor.
Structure with_confidence() {
  Structure s;
  for (int k = 0; k < 12; ++k) {
    add_residue(s, "GLY", k + 1, glycine({20.0 * k, 0, 0}));
    s.b_factors.insert(s.b_factors.end(), 4, k < 2 ? 30.0F : 90.0F);
  }
  return with_bonds(s);
}

TEST(Prepare, NamesResiduesOfLowConfidence) {
  const Structure s = with_confidence();
  const std::string named = "2 residues with a confidence (B factor) below 50: A:GLY1, A:GLY2";
  const Preparation ready = prepare(s);
  EXPECT_TRUE(ready.floppy.empty());
  EXPECT_EQ(ready.missing.back(), named + "; --floppy-below 50 leaves out their contacts");
  const Preparation floppy = prepare(s, {.floppy_below = 50.0});
  EXPECT_EQ(floppy.steps.back(), named + "; their contacts are left out");
  EXPECT_EQ(std::count(floppy.floppy.begin(), floppy.floppy.end(), true), 2);
}

TEST(Prepare, GivesABackboneItsCb) {
  Structure s;
  auto atoms = glycine({0, 0, 0});
  add_residue(s, "ALA", 1, atoms);
  const Preparation ready = prepare(with_bonds(s));
  const Structure& with_cb = ready.structure;
  const Vec3 ca = position_of(with_cb, "CA"), cb = position_of(with_cb, "CB");
  EXPECT_NEAR(distance(ca, cb), 1.53, 0.03);
  EXPECT_NEAR(degrees(position_of(with_cb, "N"), ca, cb), 110.0, 3.0);
  EXPECT_THAT(ready.missing,
              ElementsAre("side chains: none in the file; it is taken as a backbone with 1 CB "
                          "placed by rule"));
}

TEST(Prepare, PlacesTheHydrogensOfBases) {
  Structure s;  // the ring of uracil around N3, and the 2' hydroxyl group
  add_residue(s, "U", 1,
              {{"N3", "N", {0, 0, 0}},
               {"C2", "C", {-1.2, 0.7, 0}},
               {"C4", "C", {1.2, 0.7, 0}},
               {"C2'", "C", {10, 0, 0}},
               {"C1'", "C", {9, 1.1, 0}},
               {"O2'", "O", {11.4, 0, 0}}});
  const Structure ready = prepare(with_bonds(s)).structure;
  EXPECT_THAT(hydrogens_of(ready), ElementsAre("H3", "HO2'"));
  EXPECT_NEAR(distance(position_of(ready, "H3"), {0, -1.01, 0}), 0.0, 1e-12);
}

TEST(Prepare, SaysWhatItCannotPrepare) {
  Structure waters, trace;
  add_residue(waters, "HOH", 1, water({0, 0, 0}));
  EXPECT_ERROR(InputError, "made.pdb: holds nothing but water", prepare(with_bonds(waters)));
  for (int k = 1; k < 3; ++k) add_residue(trace, "ALA", k, {{"CA", "C", {3.8 * k, 0, 0}}});
  EXPECT_ERROR(
      InputError,
      "made.pdb: holds CA atoms alone: a model of a protein needs N, CA, C and O at least; "
      "Pliant has none of CA, but elastic networks need no more (ANM of ProDy)",
      prepare(with_bonds(trace)));
}

}  // namespace pliant::prepare_test
