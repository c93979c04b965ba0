// SPDX-License-Identifier: MIT
#include "pliant/laboratory/recorded_inputs.hpp"

#include <algorithm>

namespace pliant {

RunInputs recorded_inputs(std::span<const JointForce> replay, const Ordering* ordering) {
  RunInputs inputs;
  for (const auto& [joint, force] : replay) {
    inputs.replay_joints.push_back(joint);
    inputs.replay_forces.push_back(force);
  }
  if (ordering == nullptr) return inputs;
  for (const OrderedBar& visit : *ordering) {
    inputs.ordering_bars.push_back(visit.bar);
    inputs.ordering_near.push_back(visit.near);
    inputs.ordering_is_tree.push_back(visit.is_tree);
  }
  return inputs;
}

std::vector<JointForce> replay_of(const RunInputs& inputs) {
  std::vector<JointForce> replay;
  for (std::size_t k = 0; k < inputs.replay_joints.size(); ++k)
    replay.push_back({inputs.replay_joints[k], inputs.replay_forces[k]});
  return replay;
}

Ordering ordering_of(const RunInputs& inputs) {
  Ordering ordering;
  const std::size_t visits = std::min(
      {inputs.ordering_bars.size(), inputs.ordering_near.size(), inputs.ordering_is_tree.size()});
  for (std::size_t k = 0; k < visits; ++k)
    ordering.push_back(
        {inputs.ordering_bars[k], inputs.ordering_near[k], inputs.ordering_is_tree[k] != 0});
  return ordering;
}

}  // namespace pliant
