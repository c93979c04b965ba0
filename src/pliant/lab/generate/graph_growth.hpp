// SPDX-License-Identifier: MIT
// A random graph under construction: joints at random positions, and bars.
#pragma once

#include <vector>

#include "pliant/lab/generate/random_graphs.hpp"

namespace pliant {

class GraphGrowth {
 public:
  GraphGrowth(const GenerateOptions& options, const RandomKey& key);

  /// A joint at a random position in the box.
  Joint add_joint();
  /// Adds a joint with a bar to `from` (the thesis' createBar-joint-pair). Returns the joint.
  Joint add_bar_and_joint(Joint from);
  void add_bar(Joint a, Joint b);

  /// Adds a random tree below `root`: each joint of a level gets 1 to `children` children, for
  /// `depth` levels; or as many joints as the options ask for, each below a random joint.
  void add_tree(Joint root);
  /// Adds a random closed chain of 3 to `ring` joints through `start`. Returns its joints in order.
  std::vector<Joint> add_ring(Joint start);
  /// Adds a chain of `count` new joints from `from` to `to`; only a bar if `count` is 0.
  void add_path(Joint from, Joint to, std::uint64_t count);
  /// Adds random trees of depth 1 to `depth` at some of `joints`.
  void hang_trees(const std::vector<Joint>& joints);
  /// Adds a bar between a random pair of joints without one. Throws OptionError if there is no such
  /// pair.
  void add_closing_bar();

  std::uint64_t draw(std::uint64_t bound) { return draws_.below(bound); }
  std::size_t joint_count() const { return positions_.size(); }
  const GenerateOptions& options() const { return options_; }

  GeneratedGraph finish();

 private:
  void add_levels(Joint root, std::int64_t depth);
  bool has_bar(Joint a, Joint b) const;

  const GenerateOptions& options_;
  RandomSequence draws_;
  std::vector<Vec3> positions_;
  std::vector<Bar> bars_;
};

}  // namespace pliant
