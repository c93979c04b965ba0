// SPDX-License-Identifier: MIT
#include "pliant/perturb/replay.hpp"

#include <string>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

class Replay final : public Pusher {
 public:
  Replay(std::vector<JointForce> forces, const std::vector<std::int64_t>& counts, std::int64_t from)
      : forces_(std::move(forces)), from_(from) {
    if (counts.empty()) return;
    begins_.push_back(0);
    for (const std::int64_t count : counts)
      begins_.push_back(begins_.back() + static_cast<std::size_t>(count));
  }

  bool push(const PushCall& call, State& state, Push& out) override {
    const std::int64_t k = state.step - from_;
    if (k >= 0 && k < steps())
      move_by_verlet(call, forces_of(static_cast<std::size_t>(k)), state, out);
    return k + 1 < steps();
  }

 private:
  std::int64_t steps() const {
    return static_cast<std::int64_t>(begins_.empty() ? forces_.size() : begins_.size() - 1);
  }

  std::span<const JointForce> forces_of(std::size_t k) const {
    const std::span<const JointForce> all(forces_);
    return begins_.empty() ? all.subspan(k, 1)
                           : all.subspan(begins_[k], begins_[k + 1] - begins_[k]);
  }

  std::vector<JointForce> forces_;
  std::vector<std::size_t> begins_;  ///< (S + 1) of the forces of each step; empty: one each
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

void check_counts(std::span<const JointForce> replay, std::span<const std::int64_t> counts) {
  if (counts.empty()) return;
  std::size_t left = replay.size();
  for (const std::int64_t count : counts) {
    if (count < 0 || static_cast<std::uint64_t>(count) > left)
      throw OptionError("replay: a step has " + std::to_string(count) + " forces, where " +
                        std::to_string(left) + " are left");
    left -= static_cast<std::size_t>(count);
  }
  if (left > 0) throw OptionError("replay: " + std::to_string(left) + " forces belong to no step");
}

std::unique_ptr<Pusher> make_replay(const Framework& framework, const PusherOptions& options) {
  check_replay(framework, options.replay);
  check_counts(options.replay, options.replay_counts);
  return std::make_unique<Replay>(options.replay, options.replay_counts, options.replay_from);
}

}  // namespace pliant
