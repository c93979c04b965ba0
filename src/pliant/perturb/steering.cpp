// SPDX-License-Identifier: MIT
#include "pliant/perturb/steering.hpp"

#include <string>

#include "pliant/base/error.hpp"

namespace pliant {

void Steering::pull(std::span<const JointForce> forces) {
  for (const JointForce& pull : forces)
    if (!is_finite(pull.force))
      throw OptionError("steering: the force on joint " + std::to_string(pull.joint) +
                        " is not finite");
  const std::lock_guard hold(mutex_);
  asked_.assign(forces.begin(), forces.end());
}

void Steering::release() { pull({}); }

bool Steering::push(const PushCall& call, State& state, Push& out) {
  {
    const std::lock_guard hold(mutex_);
    acting_ = asked_;
  }
  const std::size_t count = call.framework.joint_count();
  for (const JointForce& pull : acting_)
    if (pull.joint >= count)
      throw OptionError("steering: joint " + std::to_string(pull.joint) + " of " +
                        std::to_string(count) + " does not exist");
  move_by_verlet(call, acting_, state, out);
  return true;
}

}  // namespace pliant
