// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_follower.hpp"

#include <unordered_map>

namespace pliant {

std::vector<JointForce> forces_of(const std::list<ImdFollower>& followers) {
  std::vector<JointForce> together;
  std::unordered_map<Joint, std::size_t> place_of;
  for (const ImdFollower& follower : followers)
    for (const JointForce& pull : follower.forces) {
      const auto [found, is_new] = place_of.try_emplace(pull.joint, together.size());
      if (is_new) {
        together.push_back(pull);
      } else {
        together[found->second].force += pull.force;
      }
    }
  return together;
}

}  // namespace pliant
