// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "pliant/resolve/bar_newton.hpp"
#include "pliant/resolve/outward_plan.hpp"
#include "pliant/resolve/project_bar.hpp"
#include "pliant/resolve/sweeps.hpp"

namespace pliant {
namespace {

std::vector<double> weights_of(const Framework& framework, const Technique& technique) {
  const auto masses = framework.inverse_masses();
  std::vector<double> weights(masses.begin(), masses.end());
  if (!technique.mass_weighted)
    for (double& weight : weights) weight = weight > 0.0 ? 1.0 : 0.0;
  return weights;
}

/// A step of the pass with what the kernel needs beside it in memory.
struct PassStep {
  Joint near, far;
  double rest;
  BarIndex bar;
  std::uint32_t block;
};

constexpr std::int64_t most_newton_iterations = 500;

class BlockPass final : public Method {
 public:
  BlockPass(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : framework_(framework),
        options_(options),
        planner_(framework),
        finish_by_sweeps_({"bfs_reverse", 0.5, technique.mass_weighted}),
        equations_(framework, weights_of(framework, technique), options.tolerance),
        newton_(equations_) {
    for (const auto& bars : planner_.blocks()) parts_.push_back(equations_.append(bars));
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    if (is_whole(call.positions)) return Stop::converged;
    if (!planned_ || planned_root_ != call.root) plan(call.root);
    const bool all_whole = pass(call, summary);
    ++summary.sweeps;
    if (all_whole && !several_pinned()) return Stop::converged;
    if (is_whole(call.positions)) return Stop::converged;
    return sweep_the_rest(call, summary);
  }

 private:
  /// With two or more pinned joints in one component bars between them are not free to follow.
  bool several_pinned() const { return framework_.pinned_count() > 1; }

  bool is_whole(std::span<const Vec3> positions) const {
    const auto bars = framework_.bars();
    const auto rests = framework_.rest_lengths();
    for (std::size_t k = 0; k < bars.size(); ++k) {
      const double error = residual(positions[bars[k].a], positions[bars[k].b], rests[k]);
      if (!(std::abs(error) <= options_.tolerance.of(rests[k]))) return false;
    }
    return true;
  }

  void plan(Joint root) {
    planner_.plan(root, outward_);
    steps_.clear();
    for (const OutwardStep& step : outward_)
      steps_.push_back({step.near, step.far,
                        step.block == no_block ? framework_.rest_lengths()[step.bar] : 0.0,
                        step.bar, step.block});
    planned_ = true;
    planned_root_ = root;
  }

  bool pass(const ResolveCall& call, ResolveSummary& summary) {
    bool all_whole = true;
    for (const PassStep& step : steps_) {
      if (step.block == no_block) {
        project(call, step);
        ++summary.projections;
      } else {
        all_whole = solve_block(call, step, summary) && all_whole;
      }
    }
    return all_whole;
  }

  void project(const ResolveCall& call, const PassStep& step) const {
    if (framework_.is_pinned(step.far)) return;
    project_bar(call.positions[step.near], call.positions[step.far], step.rest, 0.0, 1.0, [&] {
      RandomKey key = call.key;
      key.domain = Domain::escape;
      key.joint = step.bar;
      return RandomSequence(key).direction();
    });
  }

  bool solve_block(const ResolveCall& call, const PassStep& step, ResolveSummary& summary) {
    if (!parts_[step.block]) return false;
    const BarEquations::Part part = *parts_[step.block];
    equations_.hold(part, step.near);
    equations_.gather(part, call.positions);
    std::int64_t left = most_newton_iterations;
    const BarNewton::Outcome outcome = newton_.make_whole(part, [&] { return left-- > 0; });
    equations_.scatter(part, call.positions);
    summary.dropped_bars += outcome.dropped_bars;
    summary.projections += (outcome.iterations + 1) * std::int64_t(part.bars.size());
    return outcome.whole;
  }

  /// What Newton could not finish (redundant bars far from whole, coincident joints, impossible
  /// lengths) is left to plain sweeps of all bars.
  Stop sweep_the_rest(const ResolveCall& call, ResolveSummary& summary) {
    if (!sweeps_) sweeps_ = make_sweeps(framework_, finish_by_sweeps_, options_);
    const std::int64_t before = summary.sweeps;
    const Stop stop = sweeps_->resolve(call, summary);
    summary.finishing_sweeps = summary.sweeps - before;
    return stop;
  }

  const Framework& framework_;
  ResolveOptions options_;
  OutwardPlanner planner_;
  Technique finish_by_sweeps_;
  BarEquations equations_;
  std::vector<std::optional<BarEquations::Part>> parts_;  ///< none: entangled, left to sweeps
  BarNewton newton_;
  std::vector<OutwardStep> outward_;
  std::vector<PassStep> steps_;
  std::unique_ptr<Method> sweeps_;
  bool planned_ = false;
  Joint planned_root_ = 0;
};

}  // namespace

std::unique_ptr<Method> make_blocks(const Framework& framework, const Technique& technique,
                                    const ResolveOptions& options) {
  return std::make_unique<BlockPass>(framework, technique, options);
}

}  // namespace pliant
