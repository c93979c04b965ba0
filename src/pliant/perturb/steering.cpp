// SPDX-License-Identifier: MIT
#include "pliant/perturb/steering.hpp"

#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {

Steering::Steering(double longest_step) : longest_step_(longest_step) {
  if (!(longest_step > 0.0))
    throw OptionError("steering: longest step = " + number_text(longest_step) +
                      ": must be above 0");
}

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
  out.asked.insert(out.asked.end(), acting_.begin(), acting_.end());
  const bool is_held_back = longest_step_ < std::numeric_limits<double>::infinity();
  for (JointForce& pull : acting_) {
    if (is_held_back) pull = held_back(call, pull, state, longest_step_);
    move_by_verlet(call, {&pull, 1}, state, out);
  }
  return true;
}

}  // namespace pliant
