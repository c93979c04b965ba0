// SPDX-License-Identifier: MIT
#include "pliant/lab/generate/random_graphs.hpp"

#include <algorithm>
#include <string>

#include "pliant/base/choices.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/lab/generate/graph_growth.hpp"

namespace pliant {
namespace {

GeneratedGraph make_tree_with_bars(const GenerateOptions& options, const RandomKey& key,
                                   std::int64_t bars) {
  GraphGrowth growth(options, key);
  growth.add_tree(growth.add_joint());
  for (std::int64_t k = 0; k < bars; ++k) growth.add_closing_bar();
  return growth.finish();
}

GeneratedGraph make_tree(const GenerateOptions& options, const RandomKey& key) {
  return make_tree_with_bars(options, key, 0);
}

GeneratedGraph make_one_cycle_bar(const GenerateOptions& options, const RandomKey& key) {
  return make_tree_with_bars(options, key, 1);
}

GeneratedGraph make_one_cycle_ring(const GenerateOptions& options, const RandomKey& key) {
  GraphGrowth growth(options, key);
  growth.hang_trees(growth.add_ring(growth.add_joint()));
  return growth.finish();
}

GeneratedGraph make_two_cycle_bars(const GenerateOptions& options, const RandomKey& key) {
  return make_tree_with_bars(options, key, 2);
}

GeneratedGraph make_two_cycle_shared(const GenerateOptions& options, const RandomKey& key) {
  GraphGrowth growth(options, key);
  std::vector<Joint> joints = growth.add_ring(growth.add_joint());
  const std::vector<Joint> second = growth.add_ring(joints[growth.draw(joints.size())]);
  joints.insert(joints.end(), second.begin() + 1, second.end());
  growth.hang_trees(joints);
  return growth.finish();
}

/// The trees are hung on both rings before a path of the first tree's kind joins them.
GeneratedGraph make_two_cycle_tree(const GenerateOptions& options, const RandomKey& key) {
  GraphGrowth growth(options, key);
  std::vector<Joint> first = growth.add_ring(growth.add_joint());
  growth.hang_trees(first);
  const auto from = static_cast<Joint>(growth.draw(growth.joint_count()));
  Joint bridge = from;
  for (std::uint64_t k = growth.draw(std::uint64_t(options.depth)); k > 0; --k)
    bridge = growth.add_bar_and_joint(bridge);
  const Joint start = growth.add_bar_and_joint(bridge);
  growth.hang_trees(growth.add_ring(start));
  return growth.finish();
}

/// The path between two joints of a ring that are no neighbours may be a single bar.
GeneratedGraph make_two_cycle_path(const GenerateOptions& options, const RandomKey& key) {
  GraphGrowth growth(options, key);
  std::vector<Joint> ring = growth.add_ring(growth.add_joint());
  const std::size_t n = ring.size();
  const std::size_t a = growth.draw(n), b = (a + 1 + growth.draw(n - 1)) % n;
  growth.add_path(ring[a], ring[b], 1 + growth.draw(std::uint64_t(options.ring) - 2));
  growth.hang_trees(ring);
  return growth.finish();
}

GeneratedGraph make_n_cycle(const GenerateOptions& options, const RandomKey& key) {
  return make_tree_with_bars(options, key, options.cycles);
}

constexpr GraphClass table[] = {
    {"tree", "tree", "a random tree of a preset depth and number of children", make_tree},
    {"1-cycle-bar", "1-cycle", "a tree with a bar between a random pair of joints",
     make_one_cycle_bar},
    {"1-cycle-ring", "1-cycle", "a closed chain with trees hung on it", make_one_cycle_ring},
    {"2-cycle-bars", "2-cycle", "a tree with two bars between random pairs of joints",
     make_two_cycle_bars},
    {"2-cycle-shared", "2-cycle", "two closed chains that share a joint, with trees",
     make_two_cycle_shared},
    {"2-cycle-tree", "2-cycle", "two closed chains joined by a tree, with trees",
     make_two_cycle_tree},
    {"2-cycle-path", "2-cycle", "a closed chain with a path between two of its joints, with trees",
     make_two_cycle_path},
    {"n-cycle", "n-cycle", "a tree with n bars between random pairs of joints", make_n_cycle},
};

std::int64_t expected_cycles(const GraphClass& kind, const GenerateOptions& options) {
  if (kind.family == "tree") return 0;
  if (kind.family == "1-cycle") return 1;
  if (kind.family == "2-cycle") return 2;
  return options.cycles;
}

void require(bool ok, const char* name, const std::string& value, const char* range) {
  if (!ok) throw OptionError(std::string(name) + " = " + value + ": must be " + range);
}

constexpr double most_joints = 1e8;

/// Joints of a tree so many levels deep, on average.
double joints_of_levels(std::int64_t depth, std::int64_t children) {
  const double each = 0.5 * (1.0 + double(children));
  double joints = 0.0, level = 1.0;
  for (std::int64_t d = 0; d < depth && joints <= most_joints; ++d) {
    level *= each;
    joints += level;
  }
  return joints;
}

/// Refuses sizes that would fill the memory before anything else is said.
void require_few_joints(const GenerateOptions& options) {
  const double tree = joints_of_levels(options.depth, options.children);
  const double hung =
      joints_of_levels(std::max<std::int64_t>(1, options.depth / 2), options.children);
  if (double(options.joints) > most_joints || double(options.ring) > most_joints ||
      (options.joints == 0 && tree > most_joints) || double(options.ring) * hung > most_joints)
    throw OptionError("depth = " + std::to_string(options.depth) +
                      ", children = " + std::to_string(options.children) +
                      ", ring = " + std::to_string(options.ring) + ", joints = " +
                      std::to_string(options.joints) + ": make more than 100000000 joints");
}

}  // namespace

std::span<const GraphClass> graph_classes() { return table; }

const GraphClass& find_graph_class(std::string_view name) {
  return choose(graph_classes(), "class of graphs", name);
}

void check(const GenerateOptions& options) {
  require(options.depth >= 1, "depth", std::to_string(options.depth), "from 1");
  require(options.children >= 1, "children", std::to_string(options.children), "from 1");
  require(options.ring >= 3, "ring", std::to_string(options.ring), "from 3");
  require(options.cycles >= 0, "cycles", std::to_string(options.cycles), "from 0");
  require(options.joints >= 0, "joints", std::to_string(options.joints), "from 0");
  require(options.box > 0.0 && options.box < 1e100, "box", std::to_string(options.box),
          "positive and finite");
  require_few_joints(options);
}

std::string class_fault(const GraphClass& kind, const GenerateOptions& options,
                        const Framework& framework) {
  const GraphFacts facts = graph_facts(framework);
  const std::int64_t cycles = expected_cycles(kind, options);
  if (facts.components == 1 && static_cast<std::int64_t>(facts.cycles) == cycles) return "";
  return "expected a graph of class " + std::string(kind.name) + ": 1 component and " +
         std::to_string(cycles) + " independent cycles, found " + std::to_string(facts.components) +
         " and " + std::to_string(facts.cycles);
}

GeneratedGraph generate(const GraphClass& kind, const GenerateOptions& options,
                        const RandomKey& key) {
  check(options);
  GeneratedGraph graph = kind.make(options, key);
  const std::string fault = class_fault(kind, options, graph.framework);
  if (!fault.empty()) throw Error("generate: " + fault);
  return graph;
}

}  // namespace pliant
