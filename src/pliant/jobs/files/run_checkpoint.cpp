// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/run_checkpoint.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/run/run.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant {
namespace {

void add_group(const std::vector<Joint>& group, std::vector<Joint>& joints,
               std::vector<std::uint32_t>& groups) {
  const std::uint32_t number = groups.empty() ? 0 : groups.back() + 1;
  joints.insert(joints.end(), group.begin(), group.end());
  groups.insert(groups.end(), group.size(), number);
}

void add_guide(const Guide& guide, RunInputs& inputs) {
  if (guide.empty()) return;
  inputs.guide_period = guide.period;
  inputs.guide_rock = guide.rock;
  for (const Pull& pull : guide.pulls) {
    add_group(pull.joints, inputs.pull_joints, inputs.pull_groups);
    inputs.pull_to.push_back(pull.to);
  }
  for (const PairDistance& pair : guide.pairs) {
    add_group(pair.first, inputs.pair_joints, inputs.pair_groups);
    add_group(pair.second, inputs.pair_joints, inputs.pair_groups);
    inputs.pair_least.push_back(pair.least);
    inputs.pair_most.push_back(pair.most);
  }
}

/// Each group follows the one before, and there are `count`.
bool are_groups(const std::vector<std::uint32_t>& groups, std::size_t joints, std::size_t count) {
  if (groups.size() != joints) return false;
  std::size_t next = 0;
  for (const std::uint32_t group : groups) {
    if (group != next && group + 1 != next) return false;
    next = std::size_t{group} + 1;
  }
  return next == count;
}

bool fits_together(const RunInputs& inputs) {
  return are_groups(inputs.pull_groups, inputs.pull_joints.size(), inputs.pull_to.size()) &&
         are_groups(inputs.pair_groups, inputs.pair_joints.size(), 2 * inputs.pair_least.size()) &&
         inputs.pair_least.size() == inputs.pair_most.size();
}

/// One force a step, or as many as replay_counts say.
std::vector<JointForce> replay_of(const RunInputs& inputs) {
  std::vector<JointForce> replay;
  for (std::size_t k = 0; k < inputs.replay_joints.size(); ++k)
    replay.push_back({inputs.replay_joints[k], inputs.replay_forces[k]});
  return replay;
}

/// Empty: the run followed none.
Guide guide_of(const RunInputs& inputs) {
  Guide guide;
  if (inputs.guide_period == 0) return guide;
  if (!fits_together(inputs)) throw InputError("what guided it does not fit together");
  guide.period = inputs.guide_period;
  guide.rock = inputs.guide_rock;
  for (const Vec3 to : inputs.pull_to) guide.pulls.push_back({{}, to});
  for (std::size_t k = 0; k < inputs.pull_groups.size(); ++k)
    guide.pulls[inputs.pull_groups[k]].joints.push_back(inputs.pull_joints[k]);
  for (std::size_t k = 0; k < inputs.pair_least.size(); ++k)
    guide.pairs.push_back({{}, {}, inputs.pair_least[k], inputs.pair_most[k]});
  for (std::size_t k = 0; k < inputs.pair_groups.size(); ++k) {
    PairDistance& pair = guide.pairs[inputs.pair_groups[k] / 2];
    (inputs.pair_groups[k] % 2 == 0 ? pair.first : pair.second).push_back(inputs.pair_joints[k]);
  }
  return guide;
}

/// The ordering; empty where none was given.
Ordering ordering_of(const RunInputs& inputs) {
  Ordering ordering;
  const std::size_t visits = std::min(
      {inputs.ordering_bars.size(), inputs.ordering_near.size(), inputs.ordering_is_tree.size()});
  for (std::size_t k = 0; k < visits; ++k)
    ordering.push_back(
        {inputs.ordering_bars[k], inputs.ordering_near[k], inputs.ordering_is_tree[k] != 0});
  return ordering;
}

RunOptions options_in(const H5mdCheckpoint& from) {
  RunOptions options = run_options_from(from.parameters);
  options.replay = replay_of(from.inputs);
  options.replay_counts = from.inputs.replay_counts;
  options.guide = guide_of(from.inputs);
  if (options.guide.empty() && is_guided_run(from.parameters))
    throw InputError("the file does not hold the guide that it followed");
  check(options.guide, from.framework);
  if (Ordering ordering = ordering_of(from.inputs); !ordering.empty())
    options.technique.ordering = std::make_shared<Ordering>(std::move(ordering));
  options.steps = from.steps;
  options.began = from.began;
  check(options);
  return options;
}

}  // namespace

RunInputs run_inputs(const RunOptions& options) {
  RunInputs inputs;
  inputs.replay_counts = options.replay_counts;
  add_guide(options.guide, inputs);
  for (const auto& [joint, force] : options.replay) {
    inputs.replay_joints.push_back(joint);
    inputs.replay_forces.push_back(force);
  }
  if (!options.technique.ordering) return inputs;
  for (const OrderedBar& visit : *options.technique.ordering) {
    inputs.ordering_bars.push_back(visit.bar);
    inputs.ordering_near.push_back(visit.near);
    inputs.ordering_is_tree.push_back(visit.is_tree);
  }
  return inputs;
}

RunOptions run_options_from(const H5mdCheckpoint& recorded) {
  try {
    return options_in(recorded);
  } catch (const Error& error) {
    throw InputError(path_text(recorded.path) + ": its run cannot go on: " + error.what());
  }
}

}  // namespace pliant
