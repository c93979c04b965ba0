// SPDX-License-Identifier: MIT
// Fits of nodes: gradients by finite differences, minima that are known.
#include "pliant/fit/fit_nodes.hpp"

#include "pliant/base/math/lbfgs.hpp"
#include "pliant/fit/distance_term.hpp"
#include "support/gradient.hpp"
#include "support/test.hpp"

namespace pliant::fit_nodes_test {

using test::expect_gradient;

/// Two zigzags side by side, 7 Angstrom apart, joined at one end.
FitNodes hairpin(std::size_t count = 24) {
  FitNodes nodes;
  for (std::size_t k = 0; k < count; ++k) {
    const bool back = k >= count / 2;
    const double along = 3.3 * double(back ? count - 1 - k : k);
    nodes.positions.push_back({along, back ? 7.0 : 0.0, k % 2 == 0 ? 0.0 : 1.9});
    nodes.chain.push_back(0);
  }
  return nodes;
}

/// One for each node, at an arm from it.
ResidueSites all_sites(const FitNodes& nodes, Vec3 arm = {}) {
  std::vector<ResidueSite> sites;
  for (std::uint32_t k = 0; k < nodes.positions.size(); ++k)
    sites.push_back(residue_site(nodes, k, arm));
  return {nodes.positions.size(), sites};
}

std::vector<Vec3> shaken(std::vector<Vec3> x) {
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] += Vec3{0.3 * double(k % 3) - 0.3, 0.2 * double(k % 5) - 0.4, 0.25 * double(k % 4) - 0.4};
  return x;
}

TEST(FitTerms, HaveTheGradientsOfTheirValues) {
  const FitNodes nodes = hairpin();
  expect_gradient(SpringTerm(nodes), shaken(nodes.positions));
  StericTerm sterics(nodes);
  std::vector<Vec3> squeezed = shaken(nodes.positions);
  for (Vec3& x : squeezed) x.y *= 0.4;
  sterics.begin(0, squeezed);
  std::vector<Vec3> unused(squeezed.size());
  EXPECT_GT(sterics.add(squeezed, unused), 0.0);
  expect_gradient(sterics, squeezed);
  const std::vector<FitDistance> data{{.a = 0, .b = 23, .low = 9, .high = 10},
                                      {.a = 3, .b = 15, .low = 2, .high = 4}};
  const ResidueSites sites = all_sites(nodes);
  DistanceTerm distances(data, sites);
  distances.begin(2, nodes.positions);
  expect_gradient(distances, shaken(nodes.positions));
  const ResidueSites labels = all_sites(nodes, {1, 3, 2});
  DistanceTerm labelled(data, labels);
  labelled.begin(2, nodes.positions);
  expect_gradient(labelled, shaken(nodes.positions));
  const std::vector<FitDistance> any{{.a = 0, .b = 20, .low = 2, .high = 4, .more = 2},
                                     {.a = 1, .b = 19},
                                     {.a = 2, .b = 12},
                                     {.a = 3, .b = 15, .low = 2, .high = 4}};
  DistanceTerm ambiguous(any, labels);
  ambiguous.begin(2, nodes.positions);
  expect_gradient(ambiguous, shaken(nodes.positions));
}

/// Two pairs, 8 and 8 Angstrom apart, count as 8 / 2^(1/6).
TEST(DistanceTerm, TakesWhatItMayBeOfByTheSixthPower) {
  const FitNodes nodes{.positions = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, .chain = {0, 1, 2}};
  const ResidueSites sites = all_sites(nodes);
  const std::vector<FitDistance> data{{.a = 0, .b = 1, .high = 4, .more = 1}, {.a = 0, .b = 2}};
  DistanceTerm term(data, sites);
  term.begin(1, nodes.positions);
  std::vector<Vec3> unused(3);
  const double off = 8.0 / std::pow(2.0, 1.0 / 6.0) - 4.0;
  EXPECT_NEAR(term.add(nodes.positions, unused), off * off, 1e-12);
}

TEST(SpringTerm, IsAtRestAtTheStart) {
  const FitNodes nodes = hairpin();
  std::vector<Vec3> gradient(nodes.positions.size());
  EXPECT_EQ(SpringTerm(nodes).add(nodes.positions, gradient), 0.0);
  for (const Vec3 g : gradient) EXPECT_EQ(norm(g), 0.0);
}

/// Two nodes of two chains, 6 Angstrom apart: k = 1. Stretched by u it has u^2 c^2 / (c^2 + u^2).
TEST(SpringTerm, GivesWayWhenStretched) {
  const FitNodes two{.positions = {{0, 0, 0}, {6, 0, 0}}, .chain = {0, 1}};
  const SpringTerm springs(two);
  std::vector<Vec3> unused(2);
  EXPECT_NEAR(springs.add(std::vector<Vec3>{{0, 0, 0}, {8, 0, 0}}, unused), 2.0, 1e-12);
  EXPECT_NEAR(springs.add(std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}}, unused), 4.0, 1e-12);
}

/// w (u - v)^2 + u^2 of one spring and one datum: u = w v / (1 + w), where it does not give way.
TEST(FitNodes, FindTheMinimumOfASpringAndADatum) {
  const FitNodes two{.positions = {{0, 0, 0}, {6, 0, 0}}, .chain = {0, 1}};
  const std::vector<FitDistance> data{{.a = 0, .b = 1, .low = 4.5, .high = 4.5}};
  const ResidueSites sites = all_sites(two);
  DistanceTerm term(data, sites);
  FitTerm* const terms[] = {&term};
  const FittedNodes found = fit_nodes(two, terms);
  EXPECT_NEAR(distance(found.positions[0], found.positions[1]), 6.0 - 20.0 * 1.5 / 21.0, 1e-3);
}

TEST(FitNodes, OpenAHairpinAndKeepItsStrands) {
  const FitNodes nodes = hairpin();
  const std::vector<FitDistance> data{{.a = 0, .b = 23, .low = 19, .high = 20}};
  const ResidueSites sites = all_sites(nodes);
  DistanceTerm term(data, sites);
  FitTerm* const terms[] = {&term};
  const FittedNodes found = fit_nodes(nodes, terms);
  EXPECT_GT(distance(found.positions[0], found.positions[23]), 18.5);
  for (std::size_t k = 0; k + 2 < 12; ++k)
    EXPECT_NEAR(distance(found.positions[k], found.positions[k + 2]),
                distance(nodes.positions[k], nodes.positions[k + 2]), 0.5);
  EXPECT_EQ(fit_nodes(nodes, terms).positions, found.positions);
}

/// sum of k (x - k)^2 over components: its minimum is known, its curvatures differ.
TEST(Minimise, FindsTheMinimumOfASquare) {
  const ValueAndGradient square = [](std::span<const Vec3> x, std::span<Vec3> gradient) {
    double value = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const Vec3 off = x[k] - Vec3{double(k), 1.0, -2.0};
      value += double(k + 1) * norm_squared(off);
      gradient[k] = 2.0 * double(k + 1) * off;
    }
    return value;
  };
  std::vector<Vec3> x(30);
  const Minimum found = minimise(square, x, {.steps = 200, .tolerance = 1e-8, .least_gain = 0.0});
  EXPECT_TRUE(found.has_converged);
  for (std::size_t k = 0; k < x.size(); ++k)
    EXPECT_LT(distance(x[k], {double(k), 1.0, -2.0}), 1e-7);
}

}  // namespace pliant::fit_nodes_test
