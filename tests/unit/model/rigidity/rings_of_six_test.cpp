// SPDX-License-Identifier: MIT
#include "pliant/model/rigidity/rings_of_six.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "pliant/model/rigidity/rigidity_dilution.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant {
namespace rings_of_six_test {

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

/// Each hydrogen bond taken out frees some, and rows count down to none.
TEST(RigidityDilution, FreedomsGrowAsHydrogenBondsGo) {
  const MolecularModel model = test::model_of("peptide_20.pdb");
  const RigidityNetwork network = rigidity_network(model.structure, model.contacts);
  std::vector<std::size_t> seen;
  const auto rows = dilute_hydrogen_bonds(network, [&](const DilutionRow& row, const ClusterList&) {
    seen.push_back(row.hydrogen_bonds);
  });
  ASSERT_EQ(rows.size(), network.edges.size() - network.first_hydrogen_bond + 1);
  ASSERT_GT(rows.size(), 2U);
  EXPECT_EQ(seen.front(), 0U);
  EXPECT_EQ(seen.back() + 1, rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].hydrogen_bonds, rows.size() - 1 - k);
    if (k > 0) {
      EXPECT_GE(rows[k].freedoms, rows[k - 1].freedoms);
    }
  }
  EXPECT_GT(rows.back().freedoms, rows.front().freedoms);
}

}  // namespace rings_of_six_test
}  // namespace pliant
