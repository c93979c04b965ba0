// SPDX-License-Identifier: MIT
// StructGen: random frameworks of the classes of the thesis (sections 3.2 and 3.3): trees,
// 1-cycles, 2-cycles and n-cycles, at random positions in a box.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// Sizes of random graphs. The thesis gives none; the defaults make graphs of about ten to fifty
/// joints.
struct GenerateOptions {
  std::int64_t depth = 4;  ///< levels of a tree below its root, from 1
  /// largest number of children of a joint, from 1; the number is random
  std::int64_t children = 3;
  /// largest number of joints of a closed chain, from 3; the number is random
  std::int64_t ring = 8;
  std::int64_t cycles = 3;  ///< non-tree bars of an n-cycle, from 0
  std::int64_t joints = 0;  ///< joints of a tree; 0: determined by depth and children
  double box = 10.0;        ///< edge of the box from which positions are drawn (Angstrom)
};

/// Throws OptionError naming the option, its value and its range, and for sizes with more than 10^8
/// joints on average.
void check(const GenerateOptions& options);

/// A random framework with its positions, at which all bars are whole.
struct GeneratedGraph {
  Framework framework;
  std::vector<Vec3> positions;             ///< (N) Angstrom
  std::vector<std::vector<Joint>> cycles;  ///< the thesis' cycle set: a cycle for each non-tree bar
};

/// A way of making graphs of a class.
struct GraphClass {
  std::string_view name;    ///< "tree", "1-cycle-bar", ...
  std::string_view family;  ///< "tree", "1-cycle", "2-cycle", "n-cycle"
  std::string_view summary;
  /// `key` identifies the graph by its seed and by walker, the number of the graph. Its domain is
  /// set here.
  GeneratedGraph (*make)(const GenerateOptions& options, const RandomKey& key);
};

/// tree; 1-cycle by both ways of section 3.3.2; 2-cycle by all four ways of 3.3.3; n-cycle.
std::span<const GraphClass> graph_classes();

/// The row of that name. Throws OptionError listing the known names.
const GraphClass& find_graph_class(std::string_view name);

/// Says why `framework` does not belong to a class: it must be connected, with the number of
/// independent cycles of the class (options.cycles for an n-cycle). "" if it belongs to it.
std::string class_fault(const GraphClass& kind, const GenerateOptions& options,
                        const Framework& framework);

/// Makes a graph and checks its class. Throws Error if it is wrong, which would be a bug.
GeneratedGraph generate(const GraphClass& kind, const GenerateOptions& options,
                        const RandomKey& key);

}  // namespace pliant
