// SPDX-License-Identifier: MIT
// A motion with two pushers and a hand at the mouse; an ensemble in two halves. 0 if all is well.
#include <thread>

#include "pliant/pliant.hpp"

int main() {
  const pliant::Framework framework(
      {.joint_count = 4, .bars = {{0, 1}, {1, 2}, {2, 3}}, .rest_lengths = {1, 1, 1}});
  const pliant::State start({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  pliant::Motion motion(framework, start, {.push = {"force", "force_all"}});
  const auto hand = std::make_shared<pliant::Steering>();
  motion.add(hand);
  const pliant::JointForce pull{2, {0.0, 0.0, 40.0}};  // kJ/(mol Angstrom)
  const std::jthread mouse([&] { hand->pull({&pull, 1}); });
  for (int step = 0; step < 100; ++step)
    if (motion.step().stop != pliant::Stop::converged) return 1;
  std::vector<std::vector<pliant::Vec3>> ends(8);
  int same = 0;
  const auto keep_end = [&](std::uint64_t walker) {
    pliant::Watchers watchers;
    watchers.on_end = [&, walker](const auto&, const pliant::State& state) {
      same += std::exchange(ends[walker], state.positions) == state.positions;
    };
    return watchers;
  };
  for (const pliant::Shard shard : {pliant::Shard{0, 8}, {0, 4}, {4, 8}})
    pliant::run_ensemble(framework, start, {{.steps = 50}, shard, 2}, keep_end);
  return same == 8 ? 0 : 1;
}
