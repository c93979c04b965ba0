// SPDX-License-Identifier: MIT
#include "pliant/model/rigidity/rigidity.hpp"

#include "pliant/base/random.hpp"
#include "pliant/model/rigidity/rigidity_dilution.hpp"
#include "pliant/model/rigidity/rings_of_six.hpp"
#include "support/rigidity.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::rigidity_test {

using namespace test;
using testing::ElementsAre;

/// Atoms of one element letter each, at random places; bonds "0-1" or "0=1".
Structure made(const std::string& elements, const std::vector<std::string>& bonds,
               std::uint64_t seed = 1) {
  RandomSequence random({seed, Domain::generate, 0, 0, 0});
  std::vector<MadeAtom> atoms;
  static const std::vector<std::string> names{"H", "C", "N", "O", "S"};
  for (const char letter : elements)
    for (const std::string& name : names)
      if (name[0] == letter)
        atoms.push_back({name.c_str(), name.c_str(),
                         3.0 * Vec3{random.uniform(), random.uniform(), random.uniform()}});
  Structure s;
  add_residue(s, "LIG", 1, atoms);
  for (const std::string& text : bonds) {
    const std::size_t mark = text.find_first_of("-=");
    s.bonds.push_back({static_cast<std::uint32_t>(std::stoul(text)),
                       static_cast<std::uint32_t>(std::stoul(text.substr(mark + 1))),
                       BondOrigin::file, static_cast<std::uint8_t>(text[mark] == '=' ? 2 : 1)});
  }
  return s;
}

std::vector<std::string> ring_bonds(int atoms) {
  std::vector<std::string> bonds;
  for (int k = 0; k + 1 < atoms; ++k)
    bonds.push_back(std::to_string(k) + "-" + std::to_string(k + 1));
  bonds.push_back("0-" + std::to_string(atoms - 1));
  return bonds;
}

std::size_t freedoms(const Structure& structure) {
  return analyse_rigidity(structure, {}).found.freedoms;
}

TEST(Rigidity, CountsTorsionsOfSmallMolecules) {
  EXPECT_EQ(freedoms(made("C", {})), 0u) << "an atom";
  EXPECT_EQ(freedoms(made("CO", {"0=1"})), 0u) << "two atoms";
  EXPECT_EQ(freedoms(made("OHH", {"0-1", "0-2"})), 0u) << "water";
  EXPECT_EQ(freedoms(made("CCHHHHHH", {"0-1", "0-2", "0-3", "0-4", "1-5", "1-6", "1-7"})), 1u)
      << "ethane";
  EXPECT_EQ(freedoms(made("CCCCC", {"0-1", "1-2", "2-3", "3-4"})), 2u) << "pentane's heavy atoms";
  EXPECT_EQ(freedoms(made("CCCC", {"0-1", "1=2", "2-3"})), 0u) << "butene's heavy atoms";
  EXPECT_EQ(freedoms(made("CCNC", {"0-1", "1-2", "2-3"})), 1u) << "an amine";
  EXPECT_EQ(freedoms(made("COHCOH", {"0-1", "1-2", "3-4", "4-5"})), 0u)
      << "C-O-H twice: two parts, each with no torsion";
}

TEST(Rigidity, CountsRings) {
  EXPECT_EQ(freedoms(made("CCCCCC", ring_bonds(6))), 0u);
  EXPECT_EQ(freedoms(made("CCCCCCC", ring_bonds(7))), 1u);
  EXPECT_EQ(freedoms(made("CCCCCCCC", ring_bonds(8))), 2u);
}

MolecularContact hydrogen_bond(std::uint32_t d, std::uint32_t h, std::uint32_t a, std::uint32_t b,
                               double energy) {
  return {MolecularContactKind::hydrogen_bond, d, a, h, b, energy};
}

/// H-O-C-C-C-C=O: torsions O-C, C-C, C-C, C-C; with H..O closed: a ring of seven bonds that may
/// turn of eight (D-H and H..O among them), C=O does not.
Structure hydroxyaldehyde() { return made("HOCCCCO", {"0-1", "1-2", "2-3", "3-4", "4-5", "5=6"}); }

TEST(Rigidity, AHydrogenBondIsAHinge) {
  const Structure s = hydroxyaldehyde();
  EXPECT_EQ(freedoms(s), 4u);
  const std::vector<MolecularContact> bond{hydrogen_bond(1, 0, 6, 5, -2.0)};
  const Rigidity held = analyse_rigidity(s, bond);
  EXPECT_EQ(held.found.freedoms, 0u) << "a ring of seven with one bond that does not turn";
  EXPECT_THAT(held.network.turning_ends, ElementsAre(0u));
  const Rigidity still = analyse_rigidity(s, bond, {.ends_turn = false});
  EXPECT_EQ(still.found.freedoms, 0u);
  EXPECT_EQ(still.found.bars - still.found.rank, 1u) << "a ring of five";
  EXPECT_EQ(still.found.redundant[still.network.first_hydrogen_bond], 1u);
}

TEST(Rigidity, ATetherTakesTwoFreedoms) {
  const Structure s = made("CCCCCCCC", {"0-1", "1-2", "2-3", "3-4", "4-5", "5-6", "6-7"});
  const MolecularContact tether{MolecularContactKind::hydrophobic, 0, 7};
  EXPECT_EQ(freedoms(s), 5u);
  EXPECT_EQ(analyse_rigidity(s, std::vector{tether}).found.freedoms, 3u);
  EXPECT_EQ(analyse_rigidity(s, std::vector{tether},
                             {.bars = {{MolecularContactKind::hydrophobic, std::uint8_t{0}}}})
                .found.freedoms,
            5u);
}

TEST(Rigidity, RefusesWhatIsNotThere) {
  const Structure s = hydroxyaldehyde();
  EXPECT_ERROR(InputError, "contact 0 joins atoms 0 and 9: expected two of 7 (counted from 0)",
               analyse_rigidity(s, std::vector{hydrogen_bond(1, 0, 9, 5, -2.0)}));
  EXPECT_ERROR(
      OptionError, "bars of hydrophobic contacts: expected 0 to 6, found 7",
      analyse_rigidity(s, {}, {.bars = {{MolecularContactKind::hydrophobic, std::uint8_t{7}}}}));
}

/// Trees with extra bonds: the count is the rank wherever atoms are, and no less than it where they
/// are in special places.
TEST(Rigidity, IsTheRankOfHingesAtGenericPlaces) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomSequence random({seed, Domain::generate, 1, 0, 0});
    const std::uint64_t atoms = 6 + random.below(10), extra = random.below(6);
    std::vector<std::string> bonds;
    for (std::uint64_t k = 1; k < atoms; ++k)
      bonds.push_back(std::to_string(random.below(k)) + "-" + std::to_string(k));
    for (std::uint64_t k = 0; k < extra; ++k) {
      const std::uint64_t a = random.below(atoms - 1);
      const std::string bond =
          std::to_string(a) + "-" + std::to_string(a + 1 + random.below(atoms - a - 1));
      if (std::find(bonds.begin(), bonds.end(), bond) == bonds.end()) bonds.push_back(bond);
    }
    Structure s = made(std::string(atoms, 'C'), bonds, seed);
    const Rigidity found = analyse_rigidity(s, {});
    ASSERT_EQ(found.found.rank, hinge_rank(s.positions, found.network.edges)) << "seed " << seed;
    for (Vec3& position : s.positions) position.z = 0.0;  // all axes in one plane
    ASSERT_GE(found.found.rank, hinge_rank(s.positions, found.network.edges));
  }
}

/// Whether those of the first atoms that are together in `finer` are so in `coarser`.
bool is_refined_by(const ClusterList& coarser, const ClusterList& finer, std::size_t atoms) {
  std::vector<std::uint32_t> within(finer.sizes.size(), ~0u);
  for (std::size_t atom = 0; atom < atoms; ++atom) {
    std::uint32_t& cluster = within[finer.of_body[atom]];
    if (cluster != ~0u && cluster != coarser.of_body[atom]) return false;
    cluster = coarser.of_body[atom];
  }
  return true;
}

constexpr std::size_t carbons = 30;

/// A chain of carbons, hydrogens on every third of the first 24, each in a bond to another carbon.
Structure chain_with_hydrogens() {
  std::vector<std::string> bonds;
  for (std::size_t k = 0; k + 1 < carbons; ++k)
    bonds.push_back(std::to_string(k) + "-" + std::to_string(k + 1));
  for (std::size_t k = 0; k < 8; ++k)
    bonds.push_back(std::to_string(3 * k) + "-" + std::to_string(carbons + k));
  return made(std::string(carbons, 'C') + std::string(8, 'H'), bonds);
}

std::vector<MolecularContact> bonds_of_hydrogens() {
  std::vector<MolecularContact> bonds;
  for (std::uint32_t k = 0; k < 8; ++k)
    bonds.push_back(hydrogen_bond(3 * k, 30 + k, (3 * k + 4 + 2 * (k % 3)) % 30, 1,
                                  -1.0 - double((k * 5) % 8)));
  return bonds;
}

/// Each row is what the game says of the network with so many hydrogen bonds.
TEST(Dilution, IsTheCountWithFewerHydrogenBonds) {
  const Structure s = chain_with_hydrogens();
  const std::vector<MolecularContact> bonds = bonds_of_hydrogens();
  const Rigidity all = analyse_rigidity(s, bonds);
  std::vector<ClusterList> seen;
  const auto rows = dilute_hydrogen_bonds(
      all.network,
      [&](const DilutionRow&, const ClusterList& clusters) { seen.push_back(clusters); });
  ASSERT_EQ(rows.size(), 9u);
  std::vector<MolecularContact> strongest;
  for (std::size_t left = 0; left <= 8; ++left) {
    const Rigidity now = analyse_rigidity(s, strongest);
    EXPECT_EQ(rows[8 - left].hydrogen_bonds, left);
    EXPECT_EQ(rows[8 - left].freedoms, now.found.freedoms);
    EXPECT_EQ(seen[left].of_body, now.found.clusters.of_body);
    if (left < 8) strongest.push_back(bonds[all.network.contacts[left]]);
  }
  EXPECT_GT(rows[0].largest[0], rows[8].largest[0]);
}

/// Hydrogens apart, which come to rest on their donor when their bond goes.
TEST(Dilution, OnlyBreaksClusters) {
  const Structure s = chain_with_hydrogens();
  for (const bool ends_turn : {false, true}) {
    RigidityOptions options{.ends_turn = ends_turn};
    std::vector<ClusterList> seen;
    dilute_hydrogen_bonds(
        rigidity_network(s, bonds_of_hydrogens(), options),
        [&](const DilutionRow&, const ClusterList& clusters) { seen.push_back(clusters); });
    for (std::size_t left = 1; left < seen.size(); ++left)
      EXPECT_TRUE(is_refined_by(seen[left], seen[left - 1], ends_turn ? carbons : s.size()));
  }
}

RigidityNetwork network_of(const char* file, std::span<const MolecularContact> contacts = {}) {
  return rigidity_network(test::model_of(file).structure, contacts);
}

TEST(RingsOfSix, AreOfBondsThatTurn) {
  const auto count = [](const char* file) { return rings_of_six(network_of(file)).size(); };
  EXPECT_EQ(count("cyclohexane_chair.xyz"), 1U);
  EXPECT_EQ(count("glucose.cif"), 1U);
  EXPECT_EQ(count("adamantane.mol"), 4U);
  EXPECT_EQ(count("benzene.sdf"), 0U);
  EXPECT_EQ(count("butane.sdf"), 0U);
  EXPECT_EQ(count("crown_18_6.cif"), 0U);
}

TEST(RingsOfSix, GoRoundFromTheLowestAtom) {
  const auto ring = rings_of_six(network_of("cyclohexane_chair.xyz"))[0];
  EXPECT_EQ(ring[0], *std::min_element(ring.begin(), ring.end()));
  const MolecularModel model = test::model_of("cyclohexane_chair.xyz");
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(distance(model.positions[ring[k]], model.positions[ring[(k + 1) % 6]]), 1.54, 1e-6);
}

TEST(RingsOfSix, AreToldOf) {
  EXPECT_EQ(note_on_rings_of_six(0), "");
  EXPECT_TRUE(note_on_rings_of_six(1).starts_with("1 ring of six bonds that may turn"));
  EXPECT_TRUE(note_on_rings_of_six(4).starts_with("4 rings of six bonds that may turn"));
}

/// Three C-C of butane turn, C-H does not.
TEST(RigidityNetwork, HingesHaveFiveBarsAndEndsSix) {
  const RigidityNetwork network = network_of("butane.sdf");
  const auto bars = [&](int wanted) {
    return std::count_if(network.edges.begin(), network.edges.end(),
                         [&](const BodyEdge& edge) { return edge.bars == wanted; });
  };
  EXPECT_EQ(network.atoms, 14U);
  EXPECT_EQ(network.bonds, 13U);
  EXPECT_EQ(bars(5), 3);
  EXPECT_EQ(bars(6), 10);
}

}  // namespace pliant::rigidity_test
