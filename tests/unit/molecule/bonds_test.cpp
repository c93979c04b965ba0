// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/bonds.hpp"

#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::bonds_test {

using namespace test;
using testing::ElementsAre;

/// Two of glycine's shape, under these names.
Structure two_residues(const char* one, const char* other, Vec3 apart = {3.2, 1.2, 0}) {
  Structure s;
  add_residue(s, one, 1, glycine({}));
  add_residue(s, other, 2, glycine(apart));
  return s;
}

TEST(ResidueBonds, ComeFromNamesAndLinksFromNeighbours) {
  const Structure s = two_residues("GLY", "GLY");
  EXPECT_EQ(perceive(s).bonds, "0-1 1-2 2-3 residue, 2-4 link, 4-5 5-6 6-7 residue");
}

TEST(ResidueBonds, TakeOldAndNewHydrogenNames) {
  for (const char* name : {"HB1", "1HB", "HB2", "HB3", "3HB", "DB1"}) {
    Structure s;
    add_residue(s, "ALA", 1, {{"CB", "C", {}}, {name, name[0] == 'D' ? "D" : "H", {1.09, 0, 0}}});
    EXPECT_EQ(perceive(s).bonds, "0-1 residue") << name;
  }
}

TEST(ResidueBonds, HaveOrders) {
  Structure s;
  add_residue(s, "GLY", 1, glycine({}));
  perceive_bonds(s);
  EXPECT_EQ(s.bonds[1].order, 1);
  EXPECT_EQ(s.bonds[2].order, 2);
}

TEST(Links, NeedTheSameChainAndNoTerBetween) {
  Structure s;
  add_residue(s, "GLY", 1, glycine({}), "A");
  add_residue(s, "GLY", 2, glycine({3.2, 1.2, 0}), "B");
  EXPECT_EQ(perceive(s).count, 6U);
  s.atoms.residues[1].chain = "A";
  EXPECT_EQ(perceive(s).count, 7U);
  s.chain_end = {true, true};
  EXPECT_EQ(perceive(s).count, 6U);
}

TEST(Links, AreShorterThanTwoAngstrom) {
  for (const double length : {1.99, 2.01}) {
    const Structure s = two_residues("GLY", "GLY", {2.0 + length, 1.42, 0});
    EXPECT_EQ(perceive(s).count, length < 2.0 ? 7U : 6U) << length;
  }
}

TEST(Links, JoinModifiedResiduesOfAPeptide) {
  const Structure s = two_residues("GLY", "XYZ");
  EXPECT_EQ(perceive(s, {.guess_distances = false}).bonds, "0-1 1-2 2-3 residue, 2-4 link");
  EXPECT_EQ(perceive(s).bonds, "0-1 1-2 2-3 residue, 2-4 link, 4-5 5-6 6-7 distance");
}

TEST(Links, LeaveTwoUnknownResiduesToDistances) {
  const Structure s = two_residues("XYZ", "XYZ");
  EXPECT_EQ(perceive(s).bonds, "0-1 1-2 2-3 2-4 4-5 5-6 6-7 distance");
}

TEST(Links, DoNotBeginAtAMethylGroupNorJoinCoincidentAtoms) {
  Structure s;
  add_residue(s, "NME", 1, {{"N", "N", {}}, {"C", "C", {1.45, 0, 0}}});
  add_residue(s, "ALA", 2, {{"N", "N", {2.8, 0, 0}}});
  EXPECT_EQ(perceive(s).bonds, "0-1 residue");
  s = {};
  add_residue(s, "ALA", 1, {{"C", "C", {}}});
  add_residue(s, "ALA", 2, {{"N", "N", {0.2, 0, 0}}});
  EXPECT_EQ(perceive(s).bonds, "");
}

TEST(Links, CloseNoRingThatEndsWithACarboxylGroup) {
  Structure s;
  add_residue(s, "GLY", 1, {{"N", "N", {}}, {"CA", "C", {1.46, 0, 0}}, {"C", "C", {2, 1.4, 0}}});
  add_residue(s, "GLY", 2,
              {{"N", "N", {1.4, 2.6, 0}}, {"C", "C", {-0.5, 1.2, 0}}, {"OXT", "O", {-1.7, 1, 0}}});
  EXPECT_EQ(perceive(s).bonds, "0-1 1-2 residue, 2-3 link, 4-5 residue");
}

TEST(Links, CloseCyclicPeptides) {
  Structure s;
  add_residue(s, "GLY", 1, {{"N", "N", {}}, {"CA", "C", {1.46, 0, 0}}, {"C", "C", {2, 1.4, 0}}});
  add_residue(s, "GLY", 2,
              {{"N", "N", {1.4, 2.6, 0}}, {"CA", "C", {0, 2.7, 0}}, {"C", "C", {-0.5, 1.2, 0}}});
  EXPECT_EQ(perceive(s).bonds, "0-1 residue, 0-5 link, 1-2 residue, 2-3 link, 3-4 4-5 residue");
}

TEST(Links, JoinNucleotides) {
  Structure s;
  add_residue(s, "DA", 1, {{"C3'", "C", {}}, {"O3*", "O", {1.4, 0, 0}}});
  add_residue(s, "DT", 2, {{"P", "P", {2.2, 1.4, 0}}, {"O1P", "O", {3.6, 1.4, 0}}});
  EXPECT_EQ(perceive(s).bonds, "0-1 residue, 1-2 link, 2-3 residue");
}

TEST(Disulphides, JoinTheNearestSulphurs) {
  Structure s;
  add_residue(s, "CYS", 3, {{"SG", "S", {0, 0, 0}}});
  add_residue(s, "CYX", 9, {{"SG", "S", {2.05, 0, 0}}});
  add_residue(s, "CYS", 20, {{"SG", "S", {-2.3, 0, 0}}}, "B");
  EXPECT_EQ(perceive(s).bonds, "0-1 link");
}

TEST(Disulphides, AreNotMadeByThiols) {
  Structure s;
  add_residue(s, "CYS", 3, {{"SG", "S", {0, 0, 0}}, {"HG", "H", {0, 1.34, 0}}});
  add_residue(s, "CYS", 9, {{"SG", "S", {2.4, 0, 0}}});
  EXPECT_EQ(perceive(s).bonds, "0-1 residue");
}

TEST(ResidueBonds, OfAResidueThatHoldsManyMoleculesAreMadeInEach) {
  Structure s;
  std::vector<MadeAtom> atoms = water({0, 0, 0});
  for (const MadeAtom& atom : water({2.7, 0, 0})) atoms.push_back(atom);
  add_residue(s, "SOL", 1, atoms);
  EXPECT_EQ(perceive(s).bonds, "0-1 0-2 3-4 3-5 residue");
}

TEST(ResidueBonds, StretchedBeyondReasonAreLeftOutAndSaidOnce) {
  Structure s;
  add_residue(s, "ALA", 1, {{"CA", "C", {}}, {"CB", "C", {60.0, 0, 0}}, {"HB1", "H", {0, 9, 0}}});
  const Perceived found = perceive(s);
  EXPECT_EQ(found.bonds, "");
  EXPECT_THAT(found.messages,
              ElementsAre("warning: 2 bonds (first: CA(1) - CB(2), 60.00) of residue templates too "
                          "long to be true: left out (is the molecule cut by a periodic box?)"));
}

TEST(ResidueBonds, GiveWayToDistancesWhereANameMeansAnotherAtom) {
  // CHARMM's methylamide end: HT1 is not at N.
  Structure s;
  add_residue(s, "ALA", 1, {{"N", "N", {}}, {"CAT", "C", {6, 0, 0}}, {"HT1", "H", {6, 1.09, 0}}});
  EXPECT_EQ(perceive(s).bonds, "1-2 distance");
}

TEST(ResidueBonds, GiveWayToDistancesBetweenAtomsWithTemplatesToo) {
  Structure s;
  add_residue(s, "ALA", 1, {{"N", "N", {}}, {"C", "C", {6, 0, 0}}, {"HT1", "H", {6, 1.09, 0}}});
  EXPECT_EQ(perceive(s).bonds, "1-2 distance");
}

TEST(ResidueBonds, AreNotMadeToAtomsOnTopOfEachOther) {
  Structure s;
  std::vector<MadeAtom> atoms = glycine({});
  atoms.push_back({"CA", "C", {1.46, 0, 0}});
  add_residue(s, "GLY", 1, atoms);
  const Perceived found = perceive(s);
  EXPECT_EQ(found.bonds, "0-1 1-2 2-3 residue");
  EXPECT_THAT(found.messages, ElementsAre("warning: 1 atom (first: CA(5)) on top of an atom of the "
                                          "same name: no bonds perceived there"));
  add_residue(s, "LIG", 2, {{"C1", "C", {1.46, -1.5, 0}}});
  EXPECT_EQ(perceive(s).bonds, "0-1 1-2 residue, 1-5 distance, 2-3 residue");
}

TEST(FileBonds, StayAndAreMergedWithTheOthers) {
  Structure s = molecule({{"Zn", {}}, {"S", {2.3, 0, 0}}, {"C", {2.3, 1.8, 0}}});
  s.bonds = {{0, 1, BondOrigin::file, 0}, {1, 2, BondOrigin::file, 2}};
  perceive_bonds(s);
  EXPECT_EQ(bonds_text(s), "0-1 1-2 file");
  EXPECT_EQ(s.bonds[1].order, 2);
}

TEST(FileBonds, TakeTheOrderOfTheTemplateWhereTheyHaveNone) {
  Structure s;
  add_residue(s, "GLY", 1, glycine({}));
  s.bonds = {{2, 3, BondOrigin::file, 0}};
  perceive_bonds(s);
  EXPECT_EQ(bonds_text(s), "0-1 1-2 residue, 2-3 file");
  EXPECT_EQ(s.bonds[2].order, 2);
}

TEST(FileBonds, GivenTwiceKeepTheBestOriginAndTheKnownOrder) {
  Structure s = molecule({{"C", {}}, {"C", {1.3, 0, 0}}});
  s.bonds = {{0, 1, BondOrigin::distance, 2}, {0, 1, BondOrigin::file, 0}};
  perceive_bonds(s);
  EXPECT_EQ(bonds_text(s), "0-1 file");
  EXPECT_EQ(s.bonds[0].order, 2);
}

TEST(FileBonds, OfAnSdfFileAreAll) {
  Structure s = molecule({{"C", {}}, {"C", {1.5, 0, 0}}, {"C", {0, 1.5, 0}}});
  s.format = "sdf";
  s.bonds = {{0, 1, BondOrigin::file, 1}};
  EXPECT_EQ(perceive(s).bonds, "0-1 file");
  s.bonds.clear();
  EXPECT_EQ(perceive(s).bonds, "0-1 0-2 distance");
}

TEST(FileBonds, CountForTheValence) {
  // The file says that the hydrogen is the farther oxygen's.
  Structure s = molecule({{"O", {}}, {"H", {1.0, 0, 0}}, {"O", {2.2, 0, 0}}});
  s.bonds = {{1, 2, BondOrigin::file, 0}};
  EXPECT_EQ(perceive(s).bonds, "1-2 file");
}

TEST(PerceiveBonds, LeavesPlaceholdersAloneAndSaysSoOnce) {
  const Vec3 nowhere{9999.999, 9999.999, 9999.999};
  Structure s;
  add_residue(
      s, "GLY", 1,
      {{"N", "N", {}}, {"CA", "C", {1.46, 0, 0}}, {"C", "C", nowhere}, {"O", "O", nowhere}});
  const Perceived found = perceive(s);
  EXPECT_EQ(found.bonds, "0-1 residue");
  EXPECT_THAT(found.messages, ElementsAre("warning: 2 atoms (first: C(3)) at placeholder "
                                          "coordinates: no bonds perceived there"));
}

TEST(PerceiveBonds, NamesAtomsOfUnknownElementOnce) {
  Structure s;
  std::vector<MadeAtom> atoms = water({});
  atoms.push_back({"MW", "X", {0.1, 0.1, 0}});
  add_residue(s, "SOL", 1, atoms);
  add_residue(s, "SOL", 2, {{"OW", "O", {5, 0, 0}}, {"MW", "X", {5.1, 0.1, 0}}});
  const Perceived found = perceive(s);
  EXPECT_EQ(found.bonds, "0-1 0-2 residue");
  EXPECT_THAT(found.messages,
              ElementsAre("warning: 2 atoms (first: A:SOL1:MW) of unknown element without bonds"));
}

TEST(PerceiveBonds, SurvivesCoordinatesAllInOnePlace) {
  std::vector<std::pair<const char*, Vec3>> atoms(5000, {"C", {1, 2, 3}});
  atoms.push_back({"C", {10, 0, 0}});
  atoms.push_back({"C", {11.5, 0, 0}});
  const Perceived found = perceive(molecule(atoms));
  EXPECT_EQ(found.bonds, "5000-5001 distance");
  EXPECT_THAT(found.messages,
              ElementsAre("warning: 5000 atoms (first: C(1)) where atoms crowd: no bonds guessed "
                          "there (are the coordinates in Angstrom?)"));
}

TEST(PerceiveBonds, DoesNotMindAnOffset) {
  const Perceived found = perceive(
      molecule({{"C", {1e8, -1e8, 1e8}}, {"C", {1e8 + 1.5, -1e8, 1e8}}, {"H", {0, 0, 0}}}));
  EXPECT_EQ(found.bonds, "0-1 distance");
}

std::string refusal(const Structure& s) {
  Structure copy = s;
  return test::error_text<InputError>([&] { perceive_bonds(copy); });
}

TEST(PerceiveBonds, RefusesPositionsThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(molecule({{"C", {}}, {"H", {nan, 0, 0}}})),
            "position of H(2) is not a finite number");
  EXPECT_EQ(refusal(molecule({{"C", {}}, {"H", {1e16, 0, 0}}})),
            "position of H(2) is more than 1e12 Angstrom from the origin");
  Structure s = molecule({{"C", {}}, {"H", {1, 0, 0}}});
  s.positions.pop_back();
  EXPECT_EQ(refusal(s), "structure: 2 atoms but 1 positions");
}

TEST(PerceiveBonds, TakesAnEmptyStructure) { EXPECT_EQ(perceive({}).bonds, ""); }

}  // namespace pliant::bonds_test
