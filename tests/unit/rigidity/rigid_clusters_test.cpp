// SPDX-License-Identifier: MIT
#include "pliant/rigidity/rigid_clusters.hpp"

#include "pliant/base/random.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/rigidity/framework_rigidity.hpp"
#include "pliant/rigidity/pebble_game.hpp"
#include "support/rigidity.hpp"
#include "support/test.hpp"

namespace pliant::rigid_clusters_test {

using Edges = std::vector<BodyEdge>;

Edges ring_of(std::uint32_t bodies) {
  Edges edges;
  for (std::uint32_t k = 0; k < bodies; ++k) edges.push_back({k, (k + 1) % bodies, 5});
  return edges;
}

TEST(RigidClusters, ARingOfSixIsRigidAndOneOfSevenHasOneFreedom) {
  EXPECT_EQ(find_rigid_clusters(6, ring_of(6)).freedoms, 0u);
  EXPECT_EQ(find_rigid_clusters(6, ring_of(6)).clusters.sizes, std::vector<std::uint32_t>{6});
  const RigidClusters seven = find_rigid_clusters(7, ring_of(7));
  EXPECT_EQ(seven.freedoms, 1u);
  EXPECT_EQ(seven.clusters.sizes, std::vector<std::uint32_t>(7, 1));
  EXPECT_EQ(flexibility_indices(ring_of(7), seven), std::vector<double>(7, 1.0 / 7.0));
}

TEST(RigidClusters, ARingOfFiveHasARedundantBar) {
  const RigidClusters five = find_rigid_clusters(5, ring_of(5));
  EXPECT_EQ(five.rank, 24u);
  EXPECT_EQ(five.redundant, (std::vector<std::uint8_t>{0, 0, 0, 0, 1}));
  EXPECT_EQ(flexibility_indices(ring_of(5), five), std::vector<double>(5, -1.0 / 25.0));
}

TEST(RigidClusters, TwoHingesOfTwoBodiesLockThem) {
  const Edges edges{{0, 1, 5}, {0, 1, 5}};
  const RigidClusters found = find_rigid_clusters(2, edges);
  EXPECT_EQ(found.freedoms, 0u);
  EXPECT_EQ(found.redundant, (std::vector<std::uint8_t>{0, 4}));
}

TEST(RigidClusters, AChainHasAFreedomAHinge) {
  const Edges edges{{0, 1, 5}, {1, 2, 5}, {2, 3, 6}, {3, 4, 5}};
  const RigidClusters found = find_rigid_clusters(6, edges);
  EXPECT_EQ(found.freedoms, 3u);
  EXPECT_EQ(found.components, 2u) << "body 5 is alone";
  EXPECT_EQ(found.clusters.of_body, (std::vector<std::uint32_t>{1, 2, 0, 0, 3, 4}));
  EXPECT_EQ(flexibility_indices(edges, found), (std::vector<double>{1, 1, 0, 1}));
}

/// Joints and bars: 18 bars for 3 x 8 - 6 freedoms, and still it turns about the line through its
/// tips. As two bodies on a hinge it counts right.
TEST(RigidClusters, OfTheDoubleBananaAreTwo) {
  const Example& banana = find_example("double_banana_generic");
  ASSERT_EQ(banana.framework.bars().size(), 18u);
  EXPECT_EQ(test::rigidity_rank(banana.framework, banana.positions), 17u);
  EXPECT_EQ(find_rigid_clusters(2, Edges{{0, 1, 5}}).freedoms, 1u);
}

TEST(RigidClusters, RefusesEdgesThatJoinNothing) {
  EXPECT_ERROR(InputError, "edge 1 joins bodies 1 and 1: expected two of 2 (counted from 0)",
               find_rigid_clusters(2, Edges{{0, 1, 5}, {1, 1, 5}}));
  EXPECT_ERROR(InputError, "edge 0 joins bodies 0 and 2: expected two of 2 (counted from 0)",
               find_rigid_clusters(2, Edges{{0, 2, 5}}));
}

struct RandomNetwork {
  std::size_t bodies;
  Edges edges;
};

/// From a forest to far too many bars; several edges may join the same two bodies.
RandomNetwork random_network(std::uint64_t seed) {
  RandomSequence random({seed, Domain::generate, 0, 0, 0});
  RandomNetwork network{2 + random.below(9), {}};
  const std::uint64_t count = random.below(3 * network.bodies);
  for (std::uint64_t k = 0; k < count; ++k) {
    const auto a = static_cast<std::uint32_t>(random.below(network.bodies));
    const auto b = static_cast<std::uint32_t>(random.below(network.bodies));
    if (a != b) network.edges.push_back({a, b, static_cast<std::uint8_t>(random.below(8))});
  }
  return network;
}

std::vector<std::uint32_t> lowest_of(const ClusterList& clusters) {
  std::vector<std::uint32_t> lowest(clusters.sizes.size(), ~0u), of_body;
  for (std::uint32_t k = 0; k < clusters.of_body.size(); ++k)
    lowest[clusters.of_body[k]] = std::min(lowest[clusters.of_body[k]], k);
  for (const std::uint32_t cluster : clusters.of_body) of_body.push_back(lowest[cluster]);
  return of_body;
}

constexpr std::uint64_t networks = 500;

TEST(RigidClusters, OfRandomNetworksAreThoseOfTheNullSpace) {
  std::size_t rigid = 0, redundant = 0;
  for (std::uint64_t seed = 0; seed < networks; ++seed) {
    const auto [bodies, edges] = random_network(seed);
    const RigidClusters found = find_rigid_clusters(bodies, edges);
    const test::BodyBarFacts truth = test::body_bar_facts(bodies, edges, seed);
    ASSERT_EQ(found.rank, truth.rank) << "seed " << seed;
    ASSERT_EQ(lowest_of(found.clusters), truth.cluster_of) << "seed " << seed;
    ASSERT_EQ(found.bars - found.rank,
              std::accumulate(found.redundant.begin(), found.redundant.end(), std::size_t{0}));
    rigid += found.clusters.sizes.size() == 1;
    redundant += found.bars > found.rank;
  }
  EXPECT_GT(rigid, networks / 20);
  EXPECT_LT(redundant, networks);
}

/// Bars that are redundant are those whose removal changes no rank.
TEST(RigidClusters, RedundantBarsCanBeLeftOut) {
  for (std::uint64_t seed = 0; seed < networks; ++seed) {
    auto [bodies, edges] = random_network(seed);
    const RigidClusters found = find_rigid_clusters(bodies, edges);
    for (std::size_t k = 0; k < edges.size(); ++k)
      edges[k].bars = static_cast<std::uint8_t>(edges[k].bars - found.redundant[k]);
    const RigidClusters without = find_rigid_clusters(bodies, edges);
    ASSERT_EQ(without.rank, found.rank);
    ASSERT_EQ(without.bars, found.rank);
    ASSERT_EQ(without.clusters.of_body, found.clusters.of_body) << "seed " << seed;
  }
}

TEST(RigidClusters, DoNotDependOnTheOrderOfEdges) {
  for (std::uint64_t seed = 0; seed < networks; ++seed) {
    auto [bodies, edges] = random_network(seed);
    const RigidClusters found = find_rigid_clusters(bodies, edges);
    std::reverse(edges.begin(), edges.end());
    for (BodyEdge& edge : edges) std::swap(edge.a, edge.b);
    const RigidClusters again = find_rigid_clusters(bodies, edges);
    ASSERT_EQ(again.rank, found.rank);
    ASSERT_EQ(again.clusters.of_body, found.clusters.of_body) << "seed " << seed;
  }
}

/// Freedoms of blocks add up: each edge's share of its own freedoms, summed, is all of them.
TEST(FlexibilityIndices, AddUpToTheDegreesOfFreedom) {
  for (std::uint64_t seed = 0; seed < networks; ++seed) {
    const auto [bodies, edges] = random_network(seed);
    const RigidClusters found = find_rigid_clusters(bodies, edges);
    const std::vector<double> indices = flexibility_indices(edges, found);
    double sum = 0.0;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const bool is_locked =
          found.clusters.of_body[edges[k].a] == found.clusters.of_body[edges[k].b];
      ASSERT_TRUE(is_locked ? indices[k] <= 0.0 && indices[k] > -1.0
                            : indices[k] >= 0.0 && indices[k] <= 1.0);
      if (!is_locked && edges[k].bars > 0) sum += indices[k] * (6 - edges[k].bars);
    }
    ASSERT_NEAR(sum, double(found.freedoms), 1e-9) << "seed " << seed;
  }
}

TEST(PebbleGame, TwoBodiesTakeSixBars) {
  PebbleGame game(2);
  EXPECT_EQ(game.add(0, 1, 5), 5u);
  EXPECT_FALSE(game.are_locked(0, 1));
  EXPECT_EQ(game.add(1, 0, 3), 1u);
  EXPECT_TRUE(game.are_locked(0, 1));
  EXPECT_EQ(game.add(0, 1, 2), 0u);
  EXPECT_EQ(game.rank(), 6u);
}

TEST(PebbleGame, SixOrMoreBarsAtOnceMakeOneBody) {
  PebbleGame game(3);
  EXPECT_EQ(game.add(2, 1, 200), 6u);
  EXPECT_EQ(game.cluster_of(2), 1u);
  EXPECT_EQ(game.cluster_of(0), 0u);
  EXPECT_EQ(game.add(0, 2, 0), 0u) << "no bars";
}

/// A body on three bars to each of two others is locked when these two are.
TEST(PebbleGame, LocksABodyBetweenTwoThatAreLockedLater) {
  PebbleGame game(3);
  EXPECT_EQ(game.add(2, 0, 3), 3u);
  EXPECT_EQ(game.add(2, 1, 3), 3u);
  EXPECT_FALSE(game.are_locked(0, 2));
  EXPECT_EQ(game.add(0, 1, 6), 6u);
  EXPECT_TRUE(game.are_locked(0, 2));
  EXPECT_TRUE(game.are_locked(1, 2));
  EXPECT_EQ(game.cluster_of(2), 0u);
}

/// No recursion, and no search that grows with what is locked: seconds would be minutes.
TEST(PebbleGame, CountsAHundredThousandBodiesInARowAndTheirClosing) {
  constexpr std::uint32_t bodies = 100'000;
  PebbleGame game(bodies);
  for (std::uint32_t k = 0; k + 1 < bodies; ++k) ASSERT_EQ(game.add(k, k + 1, 5), 5u);
  EXPECT_EQ(game.add(bodies - 1, 0, 5), 5u);
  for (std::uint32_t k = 0; k + 6 < bodies; ++k) game.add(k, k + 6, 5);
  EXPECT_EQ(game.rank(), 6u * (bodies - 1));
  EXPECT_EQ(game.cluster_of(bodies - 1), 0u);
}

TEST(FrameworkRigidity, RanksOfExamplesAreThoseOfEigen) {
  for (const Example& example : examples()) {
    const FrameworkRigidity found = framework_rigidity(example.framework, example.positions);
    if (example.framework.has_pinned_joints() || !example.facts.whole) continue;
    EXPECT_EQ(found.rank.rank, test::rigidity_rank(example.framework, example.positions))
        << example.name;
    EXPECT_EQ(found.motions.of_whole, test::rigid_motions(example.positions)) << example.name;
    EXPECT_GE(found.generic_rank.rank, found.rank.rank) << example.name;
    EXPECT_GE(found.counted_rank, found.generic_rank.rank) << example.name;
    EXPECT_EQ(found.parts, example.facts.components) << example.name;
  }
}

/// A long chain and its angles: QR, whose bits and numbers are known.
TEST(FrameworkRigidity, AChainOfTenThousandJointsTurnsAboutItsInnerBars) {
  const Sketch sketch = with_angles(shaken(chain(10'000), 0.2));
  const FrameworkRigidity found = framework_rigidity(framework_of(sketch), sketch.positions);
  EXPECT_FALSE(found.rank.has_singular_values);
  EXPECT_EQ(found.motions.internal(), 9'997u);
  EXPECT_EQ(found.generic_motions.internal(), 9'997u);
  EXPECT_EQ(found.counted_motions.internal(), 9'997u);
  EXPECT_TRUE(found.overconstrained.empty());
}

TEST(FrameworkRigidity, OfCompleteGraphsAllBarsAreRedundant) {
  for (const std::size_t joints : {5u, 12u, 30u}) {  // the last by QR
    const Sketch sketch = complete(joints);
    const FrameworkRigidity found = framework_rigidity(framework_of(sketch), sketch.positions);
    EXPECT_EQ(found.rank.rank, 3 * joints - 6);
    ASSERT_EQ(found.overconstrained.size(), 1u);
    EXPECT_EQ(found.overconstrained[0].bars.size(), joints * (joints - 1) / 2);
    EXPECT_EQ(found.overconstrained[0].joints, joints);
    EXPECT_EQ(found.overconstrained[0].self_stresses, (joints - 3) * (joints - 4) / 2);
    EXPECT_EQ(found.generic_rank.redundant, found.rank.redundant);
  }
}

TEST(FrameworkRigidity, SayWhichPositionsAreWrong) {
  const Framework bar = framework_of(straight_chain(2));
  const std::vector<Vec3> one{{0, 0, 0}};
  EXPECT_ERROR(InputError, "positions: expected 2, one for each joint, found 1",
               framework_rigidity(bar, one));
}

}  // namespace pliant::rigid_clusters_test
