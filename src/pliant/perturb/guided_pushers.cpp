// SPDX-License-Identifier: MIT
#include "pliant/perturb/guided_pushers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

/// Moves a joint unless it is pinned; in a planar framework z counts for nothing.
void move(const PushCall& call, Joint joint, Vec3 by, State& state) {
  if (call.framework.is_pinned(joint)) return;
  if (call.framework.is_planar()) by.z = 0.0;
  state.positions[joint] += by;
}

void move_group(const PushCall& call, const std::vector<Joint>& group, Vec3 by, State& state,
                Push& out) {
  for (Joint joint : group) {
    move(call, joint, by, state);
    out.add(joint);
  }
}

class Rock final : public Pusher {
 public:
  Rock(const Guide& guide, std::int64_t from)
      : field_(guide.rock), period_(guide.period), from_(from) {}

  bool push(const PushCall& call, State& state, Push& out) override {
    const std::int64_t step = state.step - from_;
    const double share = at(step + 1) - at(step);
    for (std::size_t i = 0; i < field_.size(); ++i) {
      if (field_[i] == Vec3{}) continue;
      move(call, static_cast<Joint>(i), share * field_[i], state);
      out.add(static_cast<Joint>(i));
    }
    return true;
  }

 private:
  /// A triangular wave; sines have other bits in other libraries.
  double at(std::int64_t step) const {
    const double phase = 4.0 * double(step % period_) / double(period_);
    if (phase < 1.0) return phase;
    return phase < 3.0 ? 2.0 - phase : phase - 4.0;
  }

  std::vector<Vec3> field_;
  std::int64_t period_, from_;
};

class Pulls final : public Pusher {
 public:
  Pulls(std::vector<Pull> pulls, double displacement)
      : pulls_(std::move(pulls)), displacement_(displacement) {}

  bool push(const PushCall& call, State& state, Push& out) override {
    bool has_more = false;
    for (const Pull& pull : pulls_) {
      const Vec3 way = way_of(pull, state.positions);
      const double length = norm(way);
      if (length <= guide_slack) continue;
      has_more = true;
      move_group(call, pull.joints, std::min(1.0, displacement_ / length) * way, state, out);
    }
    return has_more;
  }

 private:
  std::vector<Pull> pulls_;
  double displacement_;
};

class PairDistances final : public Pusher {
 public:
  PairDistances(std::vector<PairDistance> pairs, double displacement)
      : pairs_(std::move(pairs)), displacement_(displacement) {}

  bool push(const PushCall& call, State& state, Push& out) override {
    bool has_more = false;
    for (const PairDistance& pair : pairs_) {
      const double excess = excess_of(pair, state.positions);
      if (std::abs(excess) <= guide_slack) continue;
      has_more = true;
      const double way = std::clamp(excess, -2.0 * displacement_, 2.0 * displacement_);
      const Vec3 towards = direction_of(pair, state.positions);
      move_group(call, pair.first, (0.5 * way) * towards, state, out);
      move_group(call, pair.second, (-0.5 * way) * towards, state, out);
    }
    return has_more;
  }

 private:
  /// The direction from the centre of the first group to that of the second; along x where they are
  /// in one place.
  static Vec3 direction_of(const PairDistance& pair, std::span<const Vec3> positions) {
    const Vec3 line = line_of(pair, positions);
    const double length = norm(line);
    return length > 1e-9 ? (1.0 / length) * line : Vec3{1.0, 0.0, 0.0};
  }

  std::vector<PairDistance> pairs_;
  double displacement_;
};

void check_displacement(const PusherOptions& options) {
  if (!(options.perturb.displacement > 0.0))
    throw OptionError("displacement = 0: must be above 0 to pull by it");
}

}  // namespace

std::unique_ptr<Pusher> make_rock(const Framework& framework, const PusherOptions& options) {
  check(options.guide, framework);
  return std::make_unique<Rock>(options.guide, options.replay_from);
}

std::unique_ptr<Pusher> make_pull(const Framework& framework, const PusherOptions& options) {
  check(options.guide, framework);
  check_displacement(options);
  return std::make_unique<Pulls>(options.guide.pulls, options.perturb.displacement);
}

std::unique_ptr<Pusher> make_pair_distance(const Framework& framework,
                                           const PusherOptions& options) {
  check(options.guide, framework);
  check_displacement(options);
  return std::make_unique<PairDistances>(options.guide.pairs, options.perturb.displacement);
}

}  // namespace pliant
