// SPDX-License-Identifier: MIT
// Bonds that distances tell.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "pliant/molecule/bonds/bonds.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::distance_bonds_test {

using namespace test;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(DistanceBonds, AreUpToTheRadiiAndTheSlack) {
  // Radii of carbon: 0.76.
  EXPECT_THAT(perceive(molecule({{"C", {}}, {"C", {1.96, 0, 0}}})).bonds,
              ElementsAre("0-1 distance"));
  EXPECT_THAT(perceive(molecule({{"C", {}}, {"C", {1.98, 0, 0}}})).bonds, IsEmpty());
  EXPECT_THAT(perceive(molecule({{"C", {}}, {"C", {0.41, 0, 0}}})).bonds,
              ElementsAre("0-1 distance"));
  EXPECT_THAT(perceive(molecule({{"C", {}}, {"C", {0.39, 0, 0}}})).bonds, IsEmpty());
}

TEST(DistanceBonds, GiveHydrogenOneBond) {
  // O-H...O of a strong hydrogen bond: the nearer oxygen has it.
  EXPECT_THAT(perceive(molecule({{"O", {}}, {"H", {1.15, 0, 0}}, {"O", {2.4, 0, 0}}})).bonds,
              ElementsAre("0-1 distance"));
}

TEST(DistanceBonds, JoinTwoHydrogensOnlyWithNothingElse) {
  EXPECT_THAT(perceive(molecule({{"H", {}}, {"H", {0.74, 0, 0}}})).bonds,
              ElementsAre("0-1 distance"));
  EXPECT_THAT(perceive(molecule({{"C", {}}, {"H", {1.09, 0, 0}}, {"H", {1.6, 0.8, 0}}})).bonds,
              ElementsAre("0-1 distance"));
}

/// Hydrogens of two residues that touch are no molecule, nor are two of one that are far apart.
TEST(DistanceBonds, JoinNoHydrogensOfTwoResidues) {
  for (double apart : {0.74, 1.0, 1.02, 1.04}) {
    Structure s;
    add_residue(s, "LIG", 1, {{"H1", "H", {}}});
    add_residue(s, "LIG", 2, {{"H1", "H", {apart, 0, 0}}});
    EXPECT_THAT(perceive(s).bonds, IsEmpty()) << apart;
  }
  EXPECT_THAT(perceive(molecule({{"H", {}}, {"H", {0.9, 0, 0}}})).bonds, IsEmpty());
}

/// HCl is 1.27 Angstrom long; dummies of PDB files lie 1 Angstrom from one another.
TEST(DistanceBonds, JoinNoHydrogenAndChlorineThatAreTooNear) {
  EXPECT_THAT(perceive(molecule({{"H", {}}, {"Cl", {1.27, 0, 0}}})).bonds,
              ElementsAre("0-1 distance"));
  EXPECT_THAT(perceive(molecule({{"H", {}}, {"Cl", {1.0, 0, 0}}})).bonds, IsEmpty());
  for (const auto& [element, length] :
       {std::pair("S", 1.34), {"P", 1.42}, {"Si", 1.48}, {"Br", 1.41}, {"Se", 1.46}})
    EXPECT_THAT(perceive(molecule({{"H", {}}, {element, {length, 0, 0}}})).bonds,
                ElementsAre("0-1 distance"))
        << element;
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
  EXPECT_THAT(perceive(molecule(atoms)).bonds,
              ElementsAre("0-2 distance", "0-3 distance", "0-4 distance", "0-5 distance",
                          "1-2 distance", "1-3 distance", "1-4 distance", "1-6 distance"));
}

TEST(DistanceBonds, AreNotMadeAcrossFourMemberedRings) {
  // Tetrafluorocyclobutadiene and dithietane as force fields draw them, cyclodisiloxane as it is.
  EXPECT_EQ(perceive(molecule({{"C", {0.7, 0.67, 0}},
                               {"C", {-0.7, 0.67, 0}},
                               {"C", {-0.7, -0.67, 0}},
                               {"C", {0.7, -0.67, 0}}}))
                .bonds.size(),
            4U);
  EXPECT_EQ(
      perceive(
          molecule(
              {{"S", {1.27, 0, 0}}, {"C", {0, 1.3, 0}}, {"S", {-1.27, 0, 0}}, {"C", {0, -1.3, 0}}}))
          .bonds.size(),
      4U);
  EXPECT_EQ(perceive(molecule({{"Si", {1.2, 0, 0}},
                               {"O", {0, 1.18, 0}},
                               {"Si", {-1.2, 0, 0}},
                               {"O", {0, -1.18, 0}}}))
                .bonds.size(),
            4U);
}

TEST(DistanceBonds, AreMadeInThreeMemberedRings) {
  // Cyclopropane, and the longest known bond of its kind: O-O of difluorodioxirane.
  EXPECT_EQ(
      perceive(molecule({{"C", {}}, {"C", {1.51, 0, 0}}, {"C", {0.755, 1.31, 0}}})).bonds.size(),
      3U);
  EXPECT_EQ(perceive(molecule({{"O", {0.789, 0, 0}}, {"O", {-0.789, 0, 0}}, {"C", {0, 1.09, 0}}}))
                .bonds.size(),
            3U);
}

TEST(DistanceBonds, GiveSulphurSixNeighbours) {
  std::vector<std::pair<const char*, Vec3>> atoms{{"S", {}}};
  for (double x : {1.56, -1.56}) {
    atoms.push_back({"F", {x, 0, 0}});
    atoms.push_back({"F", {0, x, 0}});
    atoms.push_back({"F", {0, 0, x}});
  }
  EXPECT_EQ(perceive(molecule(atoms)).bonds.size(), 6U);
}

TEST(DistanceBonds, JoinMetalsToTheirResidueAlone) {
  EXPECT_THAT(perceive(molecule({{"Zn", {}}, {"S", {2.3, 0, 0}}})).bonds,
              ElementsAre("0-1 distance"));
  EXPECT_THAT(perceive(molecule({{"Na", {}}, {"S", {2.3, 0, 0}}})).bonds, IsEmpty());
  EXPECT_THAT(perceive(molecule({{"Fe", {}}, {"Fe", {2.5, 0, 0}}})).bonds, IsEmpty());
  Structure s;
  add_residue(s, "ZN", 1, {{"ZN", "Zn", {}}});
  add_residue(s, "CYS", 2, {{"SG", "S", {2.3, 0, 0}}});
  EXPECT_THAT(perceive(s).bonds, IsEmpty());
}

TEST(DistanceBonds, SkipIonsAndNobleGases) {
  EXPECT_THAT(perceive(molecule({{"Ar", {}}, {"C", {1.5, 0, 0}}})).bonds, IsEmpty());
  Structure s;
  add_residue(s, "CL", 1, {{"CL", "Cl", {}}});
  add_residue(s, "LIG", 2, {{"C1", "C", {1.9, 0, 0}}});
  EXPECT_THAT(perceive(s).bonds, IsEmpty());
}

TEST(DistanceBonds, AreNeitherMadeBetweenWatersNorFromThem) {
  Structure s;
  add_residue(s, "HOH", 1, water({0, 0, 0}));
  add_residue(s, "HOH", 2, {{"O", "O", {1.3, 0, 0}}, {"X1", "H", {2.2, 0, 0}}});
  add_residue(s, "LIG", 3, {{"C1", "C", {0, -1.5, 0}}, {"C2", "C", {1.3, -1.45, 0}}});
  EXPECT_THAT(perceive(s).bonds,
              ElementsAre("0-1 residue", "0-2 residue", "3-4 distance", "5-6 distance"));
}

TEST(DistanceBonds, JoinLigandsToResiduesButNotSettledAtomsToEachOther) {
  Structure s;
  add_residue(s, "CYS", 1, {{"CB", "C", {}}, {"SG", "S", {1.81, 0, 0}}});
  add_residue(s, "LIG", 2, {{"C1", "C", {2.5, 1.6, 0}}});
  add_residue(s, "GLY", 3, {{"CA", "C", {0, -1.5, 0}}});  // a clash, not a bond
  EXPECT_THAT(perceive(s).bonds, ElementsAre("0-1 residue", "1-2 distance"));
}

TEST(DistanceBonds, CanBeSwitchedOff) {
  BondOptions options;
  options.guess_distances = false;
  EXPECT_THAT(perceive(molecule({{"C", {}}, {"C", {1.5, 0, 0}}}), options).bonds, IsEmpty());
}

}  // namespace pliant::distance_bonds_test
