// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/polar_atoms.hpp"

#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/atom_words.hpp"
#include "pliant/model/atoms/near_atoms.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"
#include "pliant/model/contacts/hydrogen_bond_energy.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::polar_atoms_test {

using Atoms = std::vector<std::uint32_t>;

struct Polar {
  explicit Polar(const char* file)
      : model(test::model_of(file)), graph(model.structure), atoms(model.structure, graph) {}
  std::uint32_t find(const char* residue, const char* name) const {
    const AtomTable& table = model.structure.atoms;
    for (std::uint32_t k = 0; k < table.size(); ++k)
      if (table.residues[table.residue_of[k]].name == residue && table.names[k] == name) return k;
    return no_atom;
  }
  MolecularModel model;
  AtomGraph graph;
  PolarAtoms atoms;
};

TEST(PolarAtoms, OfAspirin) {
  const Polar at("aspirin.sdf");
  EXPECT_EQ(at.atoms.hydrogens().size(), 1U);  // of the acid
  EXPECT_EQ(at.atoms.acceptors().size(), 4U);
}

TEST(PolarAtoms, HybridisationOfAPeptide) {
  const Polar at("peptide_20.pdb");
  const auto is_sp3 = [&](const char* residue, const char* atom) {
    return at.atoms.hybridisation(at.find(residue, atom)) == Hybridisation::sp3;
  };
  EXPECT_TRUE(is_sp3("SER", "OG"));
  EXPECT_TRUE(is_sp3("LYS", "NZ"));
  EXPECT_FALSE(is_sp3("TYR", "OH"));
  EXPECT_FALSE(is_sp3("ALA", "O"));
  EXPECT_FALSE(is_sp3("ALA", "N"));
}

TEST(PolarAtoms, ChargesOfAPeptide) {
  const Polar at("peptide_20.pdb");
  EXPECT_TRUE(at.atoms.is_positive(at.find("LYS", "NZ")));
  EXPECT_TRUE(at.atoms.is_positive(at.find("ARG", "NH1")));
  EXPECT_FALSE(at.atoms.is_positive(at.find("ALA", "N")));
  EXPECT_FALSE(at.atoms.is_positive(at.find("GLN", "NE2")));
  EXPECT_TRUE(at.atoms.is_negative(at.find("ASP", "OD1")));
  EXPECT_TRUE(at.atoms.is_negative(at.find("GLU", "OE2")));
  EXPECT_FALSE(at.atoms.is_negative(at.find("ASN", "OD1")));
  EXPECT_FALSE(at.atoms.is_negative(at.find("SER", "OG")));
}

TEST(PolarAtoms, APlaneIsAcrossItsBonds) {
  const Polar at("peptide_20.pdb");
  const std::uint32_t n = at.find("ALA", "N");
  const Vec3 normal = at.atoms.plane(n);
  const auto bonds = at.graph.at(n);
  const auto& x = at.model.structure.positions;
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3 along = x[bonds[k].node] - x[n];
    EXPECT_NEAR(dot(normal, along) / (norm(normal) * norm(along)), 0.0, 1e-12);
  }
}

constexpr double pi = std::numbers::pi, degree = pi / 180.0;
constexpr auto sp2 = Hybridisation::sp2, sp3 = Hybridisation::sp3;

double energy(Hybridisation donor, Hybridisation acceptor, double theta, double phi,
              double gamma = 180.0, double apart = 2.8) {
  return hydrogen_bond_energy(
      {apart, theta * degree, phi * degree, gamma * degree, donor, acceptor});
}

// theta of 120 degrees: cos^2 = 1/4, and e^-(pi/3)^6.
const double bent = 0.25 * std::exp(-std::pow(pi / 3.0, 6));

TEST(HydrogenBondEnergy, IsDeepestAtTheBestPlace) {
  EXPECT_NEAR(energy(sp3, sp3, 180.0, 109.5), -8.0, 1e-12);
  EXPECT_NEAR(energy(sp3, sp2, 180.0, 180.0), -8.0, 1e-12);
  EXPECT_NEAR(energy(sp2, sp3, 180.0, 90.0), -8.0, 1e-12);
  EXPECT_NEAR(energy(sp2, sp2, 180.0, 180.0), -8.0, 1e-12);
}

TEST(HydrogenBondEnergy, FollowsTheFourCases) {
  EXPECT_NEAR(energy(sp3, sp3, 120.0, 169.5), -8.0 * bent * 0.25, 1e-12);
  EXPECT_NEAR(energy(sp3, sp2, 120.0, 120.0), -8.0 * bent * 0.25, 1e-12);
  EXPECT_NEAR(energy(sp2, sp3, 120.0, 90.0), -8.0 * bent * bent, 1e-12);
  EXPECT_NEAR(energy(sp2, sp2, 120.0, 150.0, 135.0), -8.0 * bent * 0.75, 1e-12);
  EXPECT_NEAR(energy(sp2, sp2, 120.0, 120.0, 135.0), -8.0 * bent * 0.5, 1e-12);
}

TEST(HydrogenBondEnergy, FallsOffWithDistance) {
  // q = 2.8 / 5.6 = 1/2: 5 / 4096 - 6 / 1024 = -19 / 4096
  EXPECT_NEAR(energy(sp2, sp3, 180.0, 90.0, 180.0, 5.6), -8.0 * 19.0 / 4096.0, 1e-12);
}

TEST(HydrogenBondEnergy, OfABondThatIsTooShortIsNotRepulsive) {
  EXPECT_NEAR(energy(sp2, sp3, 180.0, 90.0, 180.0, 2.4), -4.0, 1e-12);
  EXPECT_NEAR(energy(sp3, sp2, 180.0, 120.0, 180.0, 2.4), -1.0, 1e-12);
  EXPECT_EQ(energy(sp2, sp3, 180.0, 90.0, 180.0, 2.2), 0.0);
}

TEST(HydrogenBondEnergy, OfNonsenseIsNone) {
  EXPECT_EQ(energy(sp2, sp3, 180.0, 90.0, 180.0, std::nan("")), 0.0);
  EXPECT_EQ(salt_bridge_energy(std::nan("")), 0.0);
}

TEST(SaltBridgeEnergy, IsAWellOfTen) {
  EXPECT_NEAR(salt_bridge_energy(2.825), -10.0, 1e-12);
  EXPECT_NEAR(salt_bridge_energy(6.4 - 0.375), -10.0 * 19.0 / 4096.0, 1e-12);
  EXPECT_EQ(salt_bridge_energy(2.3), -8.0);
  EXPECT_EQ(salt_bridge_energy(2.1), 0.0);
}

/// O H H of a water, then N CA C O of a glycine, then a ligand C1 H1.
Structure mixed() {
  Structure s;
  test::add_residue(s, "HOH", 1, test::water({0, 9, 0}), "W");
  test::add_residue(s, "GLY", 2, test::glycine({0, 0, 0}));
  test::add_residue(s, "LIG", 3, {{"C1", "C", {9, 0, 0}}, {"H1", "H", {10, 0, 0}}}, "L");
  perceive_bonds(s);
  return s;
}

TEST(AtomGraph, KnowsHydrogensAndHeavyNeighbours) {
  const Structure s = mixed();
  const AtomGraph graph(s);
  EXPECT_EQ(graph.hydrogens_at(0), 2U);
  EXPECT_EQ(graph.first_heavy(1), 0U);
  EXPECT_EQ(graph.heavy_at(5), (Atoms{4, 6}));
  EXPECT_EQ(graph.first_heavy(5, 4), 6U);
  EXPECT_EQ(graph.first_heavy(0), no_atom);
  EXPECT_TRUE(graph.are_within_two_bonds(3, 5));
  EXPECT_FALSE(graph.are_bonded(3, 5));
  EXPECT_FALSE(graph.are_within_two_bonds(3, 6));
}

TEST(ResidueAtoms, AreFoundByName) {
  const Structure s = mixed();
  const ResidueAtoms residues(s.atoms);
  EXPECT_EQ(residues.begin(1), 3U);
  EXPECT_EQ(residues.end(1), 7U);
  EXPECT_EQ(residues.find(1, "CA"), 4U);
  EXPECT_EQ(residues.find(1, "CB"), no_atom);
}

TEST(NearAtoms, AreThoseWithinReachButNotItself) {
  const Structure s = mixed();
  const auto near = near_atoms(s, Atoms{4, 7}, Atoms{3, 4, 5, 6, 8}, 1.6);
  EXPECT_EQ(Atoms(near.at(0).begin(), near.at(0).end()), (Atoms{3, 5}));
  EXPECT_EQ(Atoms(near.at(1).begin(), near.at(1).end()), (Atoms{8}));
}

TEST(ResidueNodes, AreAlphaCarbonsAndHeavyAtomsOfTheRest) {
  Structure s = mixed();  // one amino acid alone would be a small molecule
  test::add_residue(s, "ALA", 4, {{"N", "N", {30, 0, 0}}, {"CA", "C", {31, 0, 0}}}, "A");
  const ResidueNodes nodes = residue_nodes(s);
  EXPECT_EQ(nodes.atom, (Atoms{0, 4, 7, 10}));
  EXPECT_EQ(nodes.is_residue, (std::vector<bool>{false, true, false, true}));
  EXPECT_EQ(nodes.of_atom, (Atoms{0, 0, 0, 1, 1, 1, 1, 2, 2, 3, 3}));
}

TEST(AtomWords, AreLabelsWhereOneAtomHasIt) {
  Structure s = mixed();
  test::add_residue(s, "LIG", 3, {{"C1", "C", {19, 0, 0}}}, "L");
  const AtomWords words(s.atoms);
  EXPECT_EQ(words.word_for(4), "A:GLY2:CA");
  EXPECT_EQ(words.word_for(7), "7");  // two atoms are L:LIG3:C1
  EXPECT_EQ(words.find("A:GLY2:CA", {"x", 1}), 4U);
  EXPECT_EQ(words.find("7", {"x", 1}), 7U);
  EXPECT_TRUE(test::error_text<InputError>([&] {
                words.find("L:LIG3:C1", {"x.csv", 4});
              }).starts_with("x.csv:4: "));
  EXPECT_TRUE(test::error_text<InputError>([&] {
                words.find("Q", {"x.csv", 5});
              }).starts_with("x.csv:5: "));
}

}  // namespace pliant::polar_atoms_test
