// SPDX-License-Identifier: MIT
// The state of a walker is all that its way depends on: n + m steps are n steps, a copy of the
// state in a new Motion, and m steps, bit by bit, whatever the technique and the pushers, and also
// where steps do not converge, or are cut short.
#include "law/technique_cases.hpp"
#include "pliant/run/motion.hpp"

namespace pliant {
namespace restart_law_test {

using Names = std::vector<std::string>;

class RestartLaw : public test::TechniqueLaw {
 protected:
  static MotionOptions options_of(const Framework& framework, const Names& push) {
    MotionOptions options;
    options.technique = plain();
    options.resolve.max_sweeps = 25;
    options.resolve.seed = 11;
    options.push = push;
    options.perturb.displacement = 0.5 * test::small_break(framework);
    options.perturb.timestep = 0.02;
    const auto last = static_cast<Joint>(framework.joint_count() - 1);
    options.replay = {{0, {20, 0, 0}}, {last, {0, 9, 0}}, {last, {0, 5, 5}}, {0, {1, 1, 1}}};
    options.guide = test::guide_of(framework);
    return options;
  }

  static void each_push(const auto& look) {
    for (const Names& push : {Names{"force"},
                              {"force_all"},
                              {"displacement"},
                              {"replay"},
                              {"rock"},
                              {"pull", "pair_distance"},
                              {"force", "force"},
                              {"replay", "force"},
                              {"force", "displacement"}}) {
      std::string all;
      for (const std::string& name : push) all += name + " ";
      SCOPED_TRACE(all);
      look(push);
    }
  }
};

void expect_same(const State& one, const State& other) {
  EXPECT_TRUE(test::same_bits(one.positions, other.positions));
  EXPECT_TRUE(test::same_bits(one.previous, other.previous));
  EXPECT_EQ(one.step, other.step);
  EXPECT_EQ(one.time, other.time);
}

/// What observers see, but for positions.
void expect_same(const Frame& one, const Frame& other) {
  EXPECT_EQ(one.sweeps, other.sweeps);
  EXPECT_EQ(one.projections, other.projections);
  EXPECT_EQ(one.max_residual, other.max_residual);
  EXPECT_EQ(one.rms_residual, other.rms_residual);
  EXPECT_EQ(one.stop, other.stop);
  EXPECT_EQ(one.root_joint, other.root_joint);
  EXPECT_EQ(one.max_limit, other.max_limit);
  EXPECT_EQ(one.max_overlap, other.max_overlap);
}

TEST_P(RestartLaw, StepsOnAsIfNothingHadHappened) {
  each_example([](const Example& example) {
    if (example.framework.joint_count() == 0) return;
    each_push([&](const Names& push) {
      const MotionOptions options = options_of(example.framework, push);
      Motion whole(example.framework, State(example.positions), options, 3);
      whole.start();
      for (int step = 0; step < 2; ++step) whole.advance();
      Motion second(example.framework, whole.state(), options, 3);
      for (int step = 0; step < 3; ++step) {
        expect_same(whole.step(), second.step());
        expect_same(whole.state(), second.state());
      }
    });
  });
}

/// Whatever moment it is that somebody asks to stop at.
TEST_P(RestartLaw, AStepThatIsCutShortNeverWas) {
  each_example([](const Example& example) {
    if (example.framework.joint_count() == 0) return;
    each_push([&](const Names& push) {
      MotionOptions options = options_of(example.framework, push);
      Motion undisturbed(example.framework, State(example.positions), options);
      bool stops = false;
      options.resolve.should_stop = [&] { return stops; };
      Motion stopped(example.framework, State(example.positions), options);
      for (int step = 0; step < 4; ++step) {
        const State before = stopped.state();
        stops = true;
        if (!stopped.advance()) {
          expect_same(stopped.state(), before);
          stops = false;
          stopped.advance();
        }
        undisturbed.advance();
        expect_same(stopped.state(), undisturbed.state());
      }
    });
  });
}

PLIANT_FOR_ALL_TECHNIQUES(RestartLaw);

}  // namespace restart_law_test
}  // namespace pliant
