// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/blocks.hpp"

#include <memory>
#include <vector>

#include "pliant/resolve/blocks/block_solver.hpp"
#include "pliant/resolve/blocks/near_pass.hpp"
#include "pliant/resolve/blocks/outward_plan.hpp"
#include "pliant/resolve/method/plan_of_root.hpp"
#include "pliant/resolve/method/project_bar.hpp"
#include "pliant/resolve/sweeps/finishing_sweeps.hpp"

namespace pliant {
namespace {

/// A step of the pass with what the kernel needs beside it in memory.
struct PassStep {
  Joint near, far;
  double rest;
  BarIndex bar;
  std::uint32_t block;
};

class BlockPass final : public Method {
 public:
  BlockPass(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : framework_(framework),
        options_(options),
        planner_(framework),
        blocks_(framework, technique, options.tolerance, planner_.blocks()),
        finishing_sweeps_(framework, technique.mass_weighted, options_) {}

  bool looks_near() const override {
    return !framework_.has_pinned_joints() && blocks_.holds_all();
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    if (call.moved != nullptr && resolve_near(call, summary)) return Stop::converged;
    if (is_whole(call.positions)) return Stop::converged;
    planned_.prepare(call.disturbed.root, [this](Joint root) { plan(root); });
    note_pushed(call);
    const bool all_whole = pass(call, summary);
    ++summary.sweeps;
    if (all_whole && !several_pinned()) return Stop::converged;
    if (is_whole(call.positions)) return Stop::converged;
    return finishing_sweeps_.resolve(call, summary);
  }

 private:
  /// False if a block could not be resolved: all is as it was, for a pass over every bar.
  bool resolve_near(const ResolveCall& call, ResolveSummary& summary) {
    if (!near_)
      near_ = std::make_unique<NearPass>(framework_, planner_, blocks_, options_.tolerance);
    const ResolveSummary before = summary;
    if (near_->run(call, summary)) return true;
    call.moved->put_back(call.positions);
    call.moved->note_all(call.positions);
    summary = before;
    return false;
  }

  /// With two or more pinned joints in one component bars between them are not free to follow.
  bool several_pinned() const { return framework_.pinned_count() > 1; }

  bool is_whole(std::span<const Vec3> positions) const {
    return pliant::is_whole(framework_, positions, options_.tolerance);
  }

  void plan(Joint root) {
    planner_.plan(root, outward_);
    steps_.clear();
    for (const OutwardStep& step : outward_)
      steps_.push_back({step.near, step.far,
                        step.block == no_block ? framework_.rest_lengths()[step.bar] : 0.0,
                        step.bar, step.block});
  }

  bool pass(const ResolveCall& call, ResolveSummary& summary) {
    bool all_whole = true;
    for (const PassStep& step : steps_) {
      if (step.block == no_block) {
        project(call, step);
        ++summary.projections;
      } else {
        all_whole = solve(call, step, summary) && all_whole;
      }
    }
    return all_whole;
  }

  /// Near passes do not say where the push left all joints; by now they are all there again.
  void note_pushed(const ResolveCall& call) {
    if (call.reference.empty() || !call.pushed.empty()) return;
    pushed_.assign(call.positions.begin(), call.positions.end());
  }

  /// A block that cannot follow its push is no matter for the others.
  bool solve(const ResolveCall& call, const PassStep& step, ResolveSummary& summary) {
    if (blocks_.solve(step.block, step.near, call.key, call.positions, summary)) return true;
    if (call.reference.empty() || several_pinned()) return false;
    const std::span<const Vec3> pushed = call.pushed.empty() ? pushed_ : call.pushed;
    return blocks_.go_part_of_the_way(step.block, step.near, call.key, {call.reference, pushed},
                                      call.positions, summary);
  }

  void project(const ResolveCall& call, const PassStep& step) const {
    if (framework_.is_pinned(step.far)) return;
    carry_far(call.positions[step.near], call.positions[step.far], step.rest,
              [&] { return escape_direction(call.key, step.bar, framework_.is_planar()); });
  }

  const Framework& framework_;
  ResolveOptions options_;
  OutwardPlanner planner_;
  BlockSolver blocks_;
  FinishingSweeps finishing_sweeps_;
  std::vector<OutwardStep> outward_;
  std::vector<PassStep> steps_;
  std::vector<Vec3> pushed_;  ///< (N) what the pass began with
  std::unique_ptr<NearPass> near_;
  PlanOfRoot planned_;
};

}  // namespace

std::unique_ptr<Method> make_blocks(const Framework& framework, const Technique& technique,
                                    const ResolveOptions& options) {
  return std::make_unique<BlockPass>(framework, technique, options);
}

}  // namespace pliant
