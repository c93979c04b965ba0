// SPDX-License-Identifier: MIT
#include "pliant/perturb/guide.hpp"

#include "pliant/perturb/pushers.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::guide_test {

/// Four joints on a line, 1 Angstrom apart, without bars; the last is pinned.
Framework loose_line() { return Framework({.joint_count = 4, .pinned = {3}}); }

State on_a_line() { return State({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}); }

/// One step of a pusher of the table; whether it has more.
bool push(const std::string& name, const Framework& framework, const Guide& guide, State& state,
          Push& out, double displacement = 0.5) {
  const PusherOptions options{.perturb = {.displacement = displacement}, .guide = guide};
  out.clear();
  const bool has_more = find_pusher(name).make(framework, options)->push({framework}, state, out);
  ++state.step;
  return has_more;
}

TEST(Guide, RockingGoesToEitherSideAndComesBack) {
  const Framework framework = loose_line();
  Guide guide;
  guide.rock = {{1, 0, 0}, {0, 2, 0}, {}, {1, 1, 1}};
  guide.period = 8;
  State state = on_a_line();
  Push out;
  std::vector<double> ways;
  for (int step = 0; step < 8; ++step) {
    EXPECT_TRUE(push("rock", framework, guide, state, out));
    ways.push_back(state.positions[1].y);
  }
  EXPECT_EQ(ways, (std::vector<double>{1, 2, 1, 0, -1, -2, -1, 0}));
  EXPECT_EQ(state.positions[2], (Vec3{2, 0, 0}));  // has no vector
  EXPECT_EQ(state.positions[3], (Vec3{3, 0, 0}));  // is pinned
  EXPECT_EQ(out.joints, (std::vector<Joint>{0, 1, 3}));
}

TEST(Guide, AGroupIsPulledAsAWholeUntilItsCentreArrives) {
  const Framework framework = loose_line();
  Guide guide;
  guide.pulls = {{{0, 1}, {0.5, 1.2, 0.0}}};
  State state = on_a_line();
  Push out;
  EXPECT_TRUE(push("pull", framework, guide, state, out));
  EXPECT_EQ(state.positions[0], (Vec3{0, 0.5, 0}));
  EXPECT_EQ(state.positions[1], (Vec3{1, 0.5, 0}));
  EXPECT_FALSE(has_arrived(guide, state.positions));
  for (int step = 0; step < 2; ++step) push("pull", framework, guide, state, out);
  EXPECT_NEAR(state.positions[0].y, 1.2, 1e-12);
  EXPECT_TRUE(has_arrived(guide, state.positions));
  EXPECT_FALSE(push("pull", framework, guide, state, out));
  EXPECT_TRUE(out.joints.empty());
}

TEST(Guide, APairComesTogetherHalfEach) {
  const Framework framework = loose_line();
  Guide guide;
  guide.pairs = {{{0}, {2}, 0.5, 1.0}};
  State state = on_a_line();
  Push out;
  EXPECT_TRUE(push("pair_distance", framework, guide, state, out, 0.3));
  EXPECT_NEAR(state.positions[0].x, 0.3, 1e-12);
  EXPECT_NEAR(state.positions[2].x, 1.7, 1e-12);
  push("pair_distance", framework, guide, state, out, 0.3);
  EXPECT_NEAR(norm(line_of(guide.pairs[0], state.positions)), 1.0, 1e-12);
  EXPECT_FALSE(push("pair_distance", framework, guide, state, out, 0.3));
  EXPECT_TRUE(has_arrived(guide, state.positions));
}

TEST(Guide, APairInOnePlaceGoesApartAlongX) {
  const Framework framework = loose_line();
  Guide guide;
  guide.pairs = {{{0, 2}, {1}, 1.0, 1.0}};
  State state = on_a_line();
  Push out;
  EXPECT_TRUE(push("pair_distance", framework, guide, state, out));
  EXPECT_EQ(state.positions[1], (Vec3{1.5, 0, 0}));
  EXPECT_EQ(norm(line_of(guide.pairs[0], state.positions)), 1.0);
}

TEST(Guide, WhatMakesNoSenseIsRefused) {
  const std::pair<const char*, Guide> cases[] = {
      {"rock: 3 vectors for 4 joints", {std::vector<Vec3>(3), {}, {}}},
      {"period = 1: must be 2 or more", {{}, {}, {}, 1}},
      {"pull: joint 4 of 4 does not exist", {{}, {{{4}, {}}}, {}}},
      {"pull: a group has no joint", {{}, {{{}, {}}}, {}}},
      {"pair distance: expected a distance from 0, or two in order, found 5 to 4",
       {{}, {}, {{{0}, {1}, 5.0, 4.0}}}}};
  for (const auto& [text, guide] : cases)
    EXPECT_ERROR(OptionError, text, check(guide, loose_line()));
  const PusherOptions options{.perturb = {.displacement = 0.0}};
  const Framework framework = loose_line();
  EXPECT_THROW(find_pusher("pull").make(framework, options), OptionError);
}

TEST(Guide, NamesOfItsPushersAreThoseOfTheTable) {
  const Guide guide{{Vec3{}}, {Pull{}}, {PairDistance{}}};
  for (const std::string& name : pushers_of(guide)) EXPECT_EQ(find_pusher(name).name, name);
  EXPECT_TRUE(pushers_of({}).empty());
}

}  // namespace pliant::guide_test
