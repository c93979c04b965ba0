// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/local_sweeps.hpp"

#include <cmath>

#include "pliant/resolve/method/moved_joints.hpp"
#include "pliant/resolve/method/project_bar.hpp"
#include "pliant/resolve/method/shares.hpp"
#include "pliant/resolve/sweeps/sweeps.hpp"

namespace pliant {
namespace {

class LocalSweeps final : public Method {
 public:
  LocalSweeps(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : framework_(framework),
        technique_(technique),
        options_(options),
        everywhere_{"bfs_cycle", technique.weighting, technique.mass_weighted},
        place_(framework.joint_count(), unplaced) {}

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    if (call.moved != nullptr) {
      reach_again(call.disturbed);
      return sweep_until_whole(call, summary);
    }
    if (!sweeps_) sweeps_ = make_sweeps(framework_, everywhere_, options_);
    return sweeps_->resolve(call, summary);
  }

  bool looks_near() const override { return true; }

 private:
  static constexpr std::uint32_t unplaced = ~std::uint32_t{0};
  static constexpr BarIndex no_bar = ~BarIndex{0};

  void reach_again(const Disturbed& disturbed) {
    for (Joint joint : reached_) place_[joint] = unplaced;
    reached_.clear();
    reached_over_.clear();
    reach(disturbed.root, no_bar);
    for (Joint joint : disturbed.joints) reach(joint, no_bar);
  }

  void reach(Joint joint, BarIndex over) {
    if (place_[joint] != unplaced) return;
    place_[joint] = static_cast<std::uint32_t>(reached_.size());
    reached_.push_back(joint);
    reached_over_.push_back(over);
  }

  Stop sweep_until_whole(const ResolveCall& call, ResolveSummary& summary) {
    for (;;) {
      if (summary.sweeps == options_.max_sweeps) return Stop::max_sweeps;
      if (options_.should_stop && options_.should_stop()) return Stop::stopped_by_caller;
      const Swept swept = sweep(call, summary);
      if (!swept.finite) return Stop::not_finite;
      if (!swept.any_broken) return Stop::converged;
      ++summary.sweeps;
    }
  }

  struct Swept {
    bool any_broken = false, finite = true;
  };

  /// `reached_` grows under way: a joint joins it when it moves.
  Swept sweep(const ResolveCall& call, ResolveSummary& summary) {
    Swept swept;
    for (std::size_t k = 0; k < reached_.size() && swept.finite; ++k)
      for (const Incidence& at : framework_.neighbours(reached_[k])) {
        // From its other end, taken earlier, this bar has been looked at in this sweep already.
        if (place_[at.joint] < k) continue;
        look_at(call, reached_[k], at, swept);
        ++summary.projections;
      }
    return swept;
  }

  void look_at(const ResolveCall& call, Joint near, const Incidence& at, Swept& swept) {
    const double rest = framework_.rest_lengths()[at.bar];
    Vec3 &x_near = call.positions[near], &x_far = call.positions[at.joint];
    const double error = std::abs(residual(x_near, x_far, rest));
    if (error <= options_.tolerance.of(rest)) return;
    swept.any_broken = true;
    if (!std::isfinite(error)) {
      swept.finite = false;
      return;
    }
    call.moved->note(near, x_near);
    call.moved->note(at.joint, x_far);
    reach(at.joint, at.bar);
    // A joint is reached over the bar that moves it first: its tree bar.
    const bool is_tree = reached_over_[place_[at.joint]] == at.bar;
    const auto [near_share, far_share] = shares(technique_, {at.bar, near, is_tree}, framework_);
    project_bar(x_near, x_far, rest, near_share, far_share,
                [&] { return escape_direction(call.key, at.bar, framework_.is_planar()); });
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  Technique everywhere_;
  std::vector<std::uint32_t> place_;  ///< in reached_
  std::vector<Joint> reached_;        ///< breadth first from those disturbed
  std::vector<BarIndex> reached_over_;
  std::unique_ptr<Method> sweeps_;
};

}  // namespace

std::unique_ptr<Method> make_local_sweeps(const Framework& framework, const Technique& technique,
                                          const ResolveOptions& options) {
  return std::make_unique<LocalSweeps>(framework, technique, options);
}

}  // namespace pliant
