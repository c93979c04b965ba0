// SPDX-License-Identifier: MIT
// A motion with two pushers and a hand at the mouse; eight walkers in two halves. 0 if all is well.
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
  const auto walk = [&](std::vector<pliant::State>& ends, std::size_t first, std::size_t end) {
    for (std::size_t walker = first; walker < end; ++walker) {
      pliant::RunOptions options{.steps = 50};
      options.resolve.walker = walker;
      pliant::run(framework, ends[walker], options, {});
    }
  };
  std::vector<pliant::State> whole(8, start), halves = whole;
  walk(whole, 0, 8);
  std::jthread first_half([&] { walk(halves, 0, 4); });
  walk(halves, 4, 8);
  first_half.join();
  for (std::size_t walker = 0; walker < 8; ++walker)
    if (whole[walker].positions != halves[walker].positions) return 1;
  return 0;
}
