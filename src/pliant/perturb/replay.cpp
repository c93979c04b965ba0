// SPDX-License-Identifier: MIT
#include "pliant/perturb/replay.hpp"

#include <string>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

class Replay final : public Pusher {
 public:
  Replay(std::vector<JointForce> forces, std::int64_t from)
      : forces_(std::move(forces)), from_(from) {}

  bool push(const PushCall& call, State& state, Push& out) override {
    const std::int64_t k = state.step - from_;
    const auto count = static_cast<std::int64_t>(forces_.size());
    if (k >= 0 && k < count) move_by_verlet(call, {&forces_[std::size_t(k)], 1}, state, out);
    return k + 1 < count;
  }

 private:
  std::vector<JointForce> forces_;
  std::int64_t from_;
};

}  // namespace

void check_replay(const Framework& framework, std::span<const JointForce> replay) {
  for (const JointForce& push : replay) {
    if (push.joint >= framework.joint_count())
      throw OptionError("replay: joint " + std::to_string(push.joint) + " of " +
                        std::to_string(framework.joint_count()) + " does not exist");
    if (!is_finite(push.force))
      throw OptionError("replay: the force on " + framework.label(push.joint) + " is not finite");
  }
}

std::unique_ptr<Pusher> make_replay(const Framework& framework, const PusherOptions& options) {
  check_replay(framework, options.replay);
  return std::make_unique<Replay>(options.replay, options.replay_from);
}

}  // namespace pliant
