// SPDX-License-Identifier: MIT
// Maps as terms of fits: the mass of residues, correlations in closed form, gradients by finite
// differences.
#include "pliant/fit/map/density_term.hpp"

#include "pliant/fit/fit_nodes.hpp"
#include "pliant/fit/map/simulated.hpp"
#include "support/gradient.hpp"
#include "support/test.hpp"

namespace pliant::density_term_test {

constexpr double resolution = 8.0;

/// A helix of nodes, each with an atom of its backbone and one of a side chain.
struct Helix {
  FitNodes nodes;
  std::vector<Vec3> atoms;
  std::vector<double> weights;
  std::vector<std::uint32_t> node_of;

  Helix() {
    for (std::uint32_t k = 0; k < 20; ++k) {
      const double turn = 1.75 * k;
      const Vec3 outwards{std::cos(turn), std::sin(turn), 0};
      const Vec3 place = 2.3 * outwards + Vec3{0, 0, 1.5 * k};
      nodes.positions.push_back(place);
      nodes.chain.push_back(0);
      for (const double away : {0.5, 3.0}) {
        atoms.push_back(place + away * outwards);
        weights.push_back(away < 1 ? 24 : 18);
        node_of.push_back(k);
      }
    }
  }

  ResidueSites sites(std::size_t parts) const { return {nodes, atoms, weights, node_of, parts}; }
  DensityTarget target() const {
    const MapGrid grid = grid_around(atoms, 3 * resolution, 1.0);
    return {simulated(grid, atoms, weights, resolution), 0.0, resolution, sites(1), sites(2)};
  }
};

TEST(ResidueSites, AreWhereTheMassIsAndMoveWithIt) {
  const Helix helix;
  const ResidueSites sites = helix.sites(2);
  ASSERT_EQ(sites.size(), helix.atoms.size());
  ASSERT_EQ(sites.node_count(), 20u);
  const Rotation turn = turn_about({0.6, 0, 0.8}, 0.4);
  std::vector<Vec3> moved;
  for (const Vec3 node : helix.nodes.positions) moved.push_back(turn(node) + Vec3{3, -2, 1});
  const std::vector<Vec3> here = sites.places(helix.nodes.positions), there = sites.places(moved);
  for (std::size_t k = 2; k + 2 < here.size(); ++k) {
    EXPECT_LT(distance(here[k], helix.atoms[k]), 1e-9);
    EXPECT_LT(distance(there[k], turn(helix.atoms[k]) + Vec3{3, -2, 1}), 1e-9);
  }
}

TEST(DensityTerm, HasTheGradientOfItsValue) {
  const Helix helix;
  const DensityTarget target = helix.target();
  std::vector<Vec3> away;
  for (std::size_t k = 0; k < 20; ++k)
    away.push_back(helix.nodes.positions[k] +
                   Vec3{0.11 * double(k % 3), 0.53, 0.013 - 0.07 * double(k)});
  for (const std::size_t stage : {0, 3}) {
    DensityTerm term(target);
    term.begin(stage, away);
    test::expect_gradient(term, away, 2e-3);
  }
}

TEST(DensityTerm, IsLeastWhereTheMoleculeIs) {
  const Helix helix;
  const DensityTarget target = helix.target();
  DensityTerm term(target);
  term.begin(3, helix.nodes.positions);
  // Sites are a little wider than atoms, and end residues stand at their nodes.
  EXPECT_GT(term.correlation(helix.nodes.positions), 0.97);
  EXPECT_LE(term.correlation(helix.nodes.positions), 1.0 + 1e-6);
  std::vector<Vec3> away = helix.nodes.positions;
  for (Vec3& node : away) node.x += 4.0;
  EXPECT_LT(term.correlation(away), 0.8);
}

TEST(DensityTerm, BringsABentHelixBack) {
  const Helix helix;
  const DensityTarget target = helix.target();
  FitNodes bent = helix.nodes;
  for (Vec3& node : bent.positions) {
    const Rotation turn = turn_about({1, 0, 0}, 0.006 * node.z);
    node = turn(node);
  }
  DensityTerm term(target);
  FitTerm* const terms[] = {&term};
  const FittedNodes found = fit_nodes(bent, terms);
  double before = 0.0, after = 0.0;
  for (std::size_t k = 0; k < 20; ++k) {
    before += norm_squared(bent.positions[k] - helix.nodes.positions[k]);
    after += norm_squared(found.positions[k] - helix.nodes.positions[k]);
  }
  EXPECT_GT(std::sqrt(before / 20), 2.0);
  EXPECT_LT(std::sqrt(after / 20), 0.5);
  EXPECT_LT(fit_nodes(bent, terms, 1).strain, found.strain);
}

}  // namespace pliant::density_term_test
