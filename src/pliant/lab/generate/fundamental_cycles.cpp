// SPDX-License-Identifier: MIT
#include "pliant/lab/generate/fundamental_cycles.hpp"

#include <algorithm>
#include <limits>

namespace pliant {
namespace {

constexpr auto none = std::numeric_limits<std::uint32_t>::max();

struct Forest {
  std::vector<Joint> parent;
  std::vector<std::uint32_t> level;
  std::vector<bool> is_tree;  ///< of bars
};

Forest breadth_first_forest(const Framework& framework) {
  Forest forest{std::vector<Joint>(framework.joint_count(), none),
                std::vector<std::uint32_t>(framework.joint_count(), none),
                std::vector<bool>(framework.bar_count(), false)};
  std::vector<Joint> queue;
  for (std::size_t i = 0; i < framework.joint_count(); ++i) {
    if (forest.level[i] != none) continue;
    queue.assign(1, static_cast<Joint>(i));
    forest.level[i] = 0;
    for (std::size_t next = 0; next < queue.size(); ++next)
      for (const Incidence& at : framework.neighbours(queue[next])) {
        if (forest.level[at.joint] != none) continue;
        forest.level[at.joint] = forest.level[queue[next]] + 1;
        forest.parent[at.joint] = queue[next];
        forest.is_tree[at.bar] = true;
        queue.push_back(at.joint);
      }
  }
  return forest;
}

/// Goes up from both ends of the bar until the ways meet.
std::vector<Joint> cycle_of(const Forest& forest, Bar bar) {
  std::vector<Joint> from_a{bar.a}, from_b{bar.b};
  while (from_a.back() != from_b.back()) {
    auto& lower = forest.level[from_a.back()] >= forest.level[from_b.back()] ? from_a : from_b;
    lower.push_back(forest.parent[lower.back()]);
  }
  from_a.insert(from_a.end(), from_b.rbegin() + 1, from_b.rend());
  return from_a;
}

}  // namespace

std::vector<std::vector<Joint>> fundamental_cycles(const Framework& framework) {
  const Forest forest = breadth_first_forest(framework);
  std::vector<std::vector<Joint>> cycles;
  for (std::size_t k = 0; k < framework.bar_count(); ++k)
    if (!forest.is_tree[k]) cycles.push_back(cycle_of(forest, framework.bars()[k]));
  return cycles;
}

}  // namespace pliant
