// SPDX-License-Identifier: MIT
// Bonds that distances tell.
#include "pliant/molecule/bonds/bonds.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::distance_bonds_test {

using namespace test;

/// Radii of carbon: 0.76. HCl is 1.27 Angstrom long; dummies of PDB files lie 1 Angstrom from one
/// another.
TEST(DistanceBonds, OfTwoAtomsAreUpToTheRadiiAndTheSlackAndNotTooShort) {
  const struct {
    const char *one, *other;
    double apart;
    bool is_bonded;
  } cases[] = {{"C", "C", 1.96, true},   {"C", "C", 1.98, false}, {"C", "C", 0.41, true},
               {"C", "C", 0.39, false},  {"H", "H", 0.74, true},  {"H", "H", 0.9, false},
               {"H", "Cl", 1.27, true},  {"H", "Cl", 1.0, false}, {"H", "S", 1.34, true},
               {"H", "P", 1.42, true},   {"H", "Si", 1.48, true}, {"H", "Br", 1.41, true},
               {"H", "Se", 1.46, true},  {"Zn", "S", 2.3, true},  {"Na", "S", 2.3, false},
               {"Fe", "Fe", 2.5, false}, {"Ar", "C", 1.5, false}};
  for (const auto& [one, other, apart, is_bonded] : cases)
    EXPECT_EQ(perceive(molecule({{one, {}}, {other, {apart, 0, 0}}})).count, is_bonded)
        << one << other << apart;
}

TEST(DistanceBonds, GiveHydrogenOneBond) {
  // O-H...O of a strong hydrogen bond: the nearer oxygen has it.
  EXPECT_EQ(perceive(molecule({{"O", {}}, {"H", {1.15, 0, 0}}, {"O", {2.4, 0, 0}}})).bonds,
            "0-1 distance");
  EXPECT_EQ(perceive(molecule({{"C", {}}, {"H", {1.09, 0, 0}}, {"H", {1.6, 0.8, 0}}})).bonds,
            "0-1 distance");
}

/// Hydrogens of two residues that touch are no molecule.
TEST(DistanceBonds, JoinNoHydrogensOfTwoResidues) {
  for (double apart : {0.74, 1.0, 1.02, 1.04}) {
    Structure s;
    add_residue(s, "LIG", 1, {{"H1", "H", {}}});
    add_residue(s, "LIG", 2, {{"H1", "H", {apart, 0, 0}}});
    EXPECT_EQ(perceive(s).bonds, "") << apart;
  }
}

TEST(DistanceBonds, BeyondTheValenceGoLongestFirst) {
  // The cage carbons of bicyclo[1.1.1]pentane are 1.87 Angstrom apart and not bonded.
  const double r = 1.55, h = 0.935;
  const double ring = std::sqrt(r * r - h * h);
  std::vector<std::pair<const char*, Vec3>> atoms{{"C", {0, 0, h}}, {"C", {0, 0, -h}}};
  for (int k = 0; k < 3; ++k) {
    const double angle = k * 2.0 * std::acos(-1.0) / 3.0;
    atoms.push_back({"C", {ring * std::cos(angle), ring * std::sin(angle), 0}});
  }
  atoms.push_back({"H", {0, 0, h + 1.09}});
  atoms.push_back({"H", {0, 0, -h - 1.09}});
  EXPECT_EQ(perceive(molecule(atoms)).bonds, "0-2 0-3 0-4 0-5 1-2 1-3 1-4 1-6 distance");
}

TEST(DistanceBonds, AreNotMadeAcrossFourMemberedRings) {
  // Tetrafluorocyclobutadiene and dithietane as force fields draw them, cyclodisiloxane as it is.
  const struct {
    const char *one, *other;
    Vec3 at, then;
  } cases[] = {{"C", "C", {0.7, 0.67, 0}, {-0.7, 0.67, 0}},
               {"S", "C", {1.27, 0, 0}, {0, 1.3, 0}},
               {"Si", "O", {1.2, 0, 0}, {0, 1.18, 0}}};
  for (const auto& [one, other, at, then] : cases)
    EXPECT_EQ(perceive(molecule({{one, at}, {other, then}, {one, -at}, {other, -then}})).count, 4U)
        << one;
}

TEST(DistanceBonds, AreMadeInThreeMemberedRings) {
  // Cyclopropane, and the longest known bond of its kind: O-O of difluorodioxirane.
  EXPECT_EQ(perceive(molecule({{"C", {}}, {"C", {1.51, 0, 0}}, {"C", {0.755, 1.31, 0}}})).count,
            3U);
  EXPECT_EQ(
      perceive(molecule({{"O", {0.789, 0, 0}}, {"O", {-0.789, 0, 0}}, {"C", {0, 1.09, 0}}})).count,
      3U);
}

TEST(DistanceBonds, GiveSulphurSixNeighbours) {
  std::vector<std::pair<const char*, Vec3>> atoms{{"S", {}}};
  for (double x : {1.56, -1.56}) {
    atoms.push_back({"F", {x, 0, 0}});
    atoms.push_back({"F", {0, x, 0}});
    atoms.push_back({"F", {0, 0, x}});
  }
  EXPECT_EQ(perceive(molecule(atoms)).count, 6U);
}

TEST(DistanceBonds, JoinNoMetalsToOtherResidues) {
  Structure s;
  add_residue(s, "ZN", 1, {{"ZN", "Zn", {}}});
  add_residue(s, "CYS", 2, {{"SG", "S", {2.3, 0, 0}}});
  EXPECT_EQ(perceive(s).bonds, "");
}

TEST(DistanceBonds, SkipIons) {
  Structure s;
  add_residue(s, "CL", 1, {{"CL", "Cl", {}}});
  add_residue(s, "LIG", 2, {{"C1", "C", {1.9, 0, 0}}});
  EXPECT_EQ(perceive(s).bonds, "");
}

TEST(DistanceBonds, AreNeitherMadeBetweenWatersNorFromThem) {
  Structure s;
  add_residue(s, "HOH", 1, water({0, 0, 0}));
  add_residue(s, "HOH", 2, {{"O", "O", {1.3, 0, 0}}, {"X1", "H", {2.2, 0, 0}}});
  add_residue(s, "LIG", 3, {{"C1", "C", {0, -1.5, 0}}, {"C2", "C", {1.3, -1.45, 0}}});
  EXPECT_EQ(perceive(s).bonds, "0-1 0-2 residue, 3-4 5-6 distance");
}

TEST(DistanceBonds, JoinLigandsToResiduesButNotSettledAtomsToEachOther) {
  Structure s;
  add_residue(s, "CYS", 1, {{"CB", "C", {}}, {"SG", "S", {1.81, 0, 0}}});
  add_residue(s, "LIG", 2, {{"C1", "C", {2.5, 1.6, 0}}});
  add_residue(s, "GLY", 3, {{"CA", "C", {0, -1.5, 0}}});  // a clash, not a bond
  EXPECT_EQ(perceive(s).bonds, "0-1 residue, 1-2 distance");
}

TEST(DistanceBonds, CanBeSwitchedOff) {
  EXPECT_EQ(perceive(molecule({{"C", {}}, {"C", {1.5, 0, 0}}}), {.guess_distances = false}).bonds,
            "");
}

}  // namespace pliant::distance_bonds_test
