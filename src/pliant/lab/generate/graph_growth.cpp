// SPDX-License-Identifier: MIT
#include "pliant/lab/generate/graph_growth.hpp"

#include <algorithm>

#include "pliant/base/error.hpp"
#include "pliant/lab/generate/fundamental_cycles.hpp"

namespace pliant {
namespace {

RandomKey with_domain(RandomKey key) {
  key.domain = Domain::generate;
  return key;
}

}  // namespace

GraphGrowth::GraphGrowth(const GenerateOptions& options, const RandomKey& key)
    : options_(options), draws_(with_domain(key)) {}

Joint GraphGrowth::add_joint() {
  const double x = draws_.uniform(), y = draws_.uniform(), z = draws_.uniform();
  positions_.push_back(options_.box * Vec3{x, y, z});
  return static_cast<Joint>(positions_.size() - 1);
}

Joint GraphGrowth::add_bar_and_joint(Joint from) {
  const Joint joint = add_joint();
  add_bar(from, joint);
  return joint;
}

void GraphGrowth::add_bar(Joint a, Joint b) { bars_.push_back({a, b}); }

void GraphGrowth::add_tree(Joint root) {
  if (options_.joints == 0) return add_levels(root, options_.depth);
  while (static_cast<std::int64_t>(joint_count()) < options_.joints)
    add_bar_and_joint(static_cast<Joint>(draw(joint_count())));
}

/// Level by level rather than by recursion, so that depth costs no stack.
void GraphGrowth::add_levels(Joint root, std::int64_t depth) {
  std::vector<Joint> level{root}, below;
  for (std::int64_t d = 0; d < depth; ++d) {
    below.clear();
    for (Joint joint : level) {
      const std::uint64_t children = 1 + draw(static_cast<std::uint64_t>(options_.children));
      for (std::uint64_t c = 0; c < children; ++c) below.push_back(add_bar_and_joint(joint));
    }
    level.swap(below);
  }
}

std::vector<Joint> GraphGrowth::add_ring(Joint start) {
  const std::uint64_t size = 3 + draw(static_cast<std::uint64_t>(options_.ring) - 2);
  std::vector<Joint> ring{start};
  while (ring.size() < size) ring.push_back(add_bar_and_joint(ring.back()));
  add_bar(ring.back(), start);
  return ring;
}

void GraphGrowth::add_path(Joint from, Joint to, std::uint64_t count) {
  for (std::uint64_t k = 0; k < count; ++k) from = add_bar_and_joint(from);
  add_bar(from, to);
}

void GraphGrowth::hang_trees(const std::vector<Joint>& joints) {
  for (Joint joint : joints)
    if (draw(2) == 0)
      add_levels(joint, 1 + static_cast<std::int64_t>(draw(static_cast<std::uint64_t>(
                                std::max<std::int64_t>(1, options_.depth / 2)))));
}

bool GraphGrowth::has_bar(Joint a, Joint b) const {
  return std::any_of(bars_.begin(), bars_.end(), [&](Bar bar) {
    return (bar.a == a && bar.b == b) || (bar.a == b && bar.b == a);
  });
}

void GraphGrowth::add_closing_bar() {
  const std::uint64_t n = joint_count();
  if (bars_.size() >= n * (n - 1) / 2)
    throw OptionError("no pair of the " + std::to_string(n) + " joints is left for another bar");
  for (;;) {
    const auto a = static_cast<Joint>(draw(n)), b = static_cast<Joint>(draw(n));
    if (a == b || has_bar(a, b)) continue;
    return add_bar(a, b);
  }
}

GeneratedGraph GraphGrowth::finish() {
  FrameworkParts parts;
  parts.joint_count = positions_.size();
  parts.bars = bars_;
  for (Bar bar : bars_)
    parts.rest_lengths.push_back(distance(positions_[bar.a], positions_[bar.b]));
  GeneratedGraph graph{Framework(std::move(parts)), std::move(positions_), {}};
  graph.cycles = fundamental_cycles(graph.framework);
  return graph;
}

}  // namespace pliant
