// SPDX-License-Identifier: MIT
#include "pliant/resolve/equations/direct_method.hpp"

#include <algorithm>

#include "pliant/framework/graph.hpp"
#include "pliant/resolve/sweeps/finishing_sweeps.hpp"

namespace pliant {
namespace {

/// Bars of each component that has any.
std::vector<std::vector<BarIndex>> bars_of_components(const Framework& framework) {
  const Components components = find_components(framework);
  std::vector<std::vector<BarIndex>> bars(components.count);
  for (BarIndex k = 0; k < framework.bar_count(); ++k)
    bars[components.of_node[framework.bars()[k].a]].push_back(k);
  std::erase_if(bars, [](const auto& of_component) { return of_component.empty(); });
  return bars;
}

std::vector<double> inverse_masses(const Framework& framework) {
  return {framework.inverse_masses().begin(), framework.inverse_masses().end()};
}

/// How many iterations a component may still take; asks the caller after each.
class Budget {
 public:
  explicit Budget(const ResolveOptions& options) : options_(options) {}
  bool may_go_on() {
    if (ended_) return false;
    stopped_ = taken_ > 0 && options_.should_stop && options_.should_stop();
    ended_ = stopped_ || taken_ == options_.max_sweeps;
    ++taken_;
    return !ended_;
  }
  bool stopped_by_caller() const { return stopped_; }

 private:
  const ResolveOptions& options_;
  std::int64_t taken_ = 0;
  bool ended_ = false, stopped_ = false;
};

class DirectMethod final : public Method {
 public:
  DirectMethod(const Framework& framework, const ResolveOptions& options, MakePartSolver make)
      : framework_(framework),
        options_(options),
        components_(framework, options.tolerance),
        equations_(components_.equations()),
        finishing_sweeps_(framework, true, options_) {
    broken_.resize(equations_.joint_count());
    solver_ = make(equations_);
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    bool all_whole = !components_.entangled();
    for (const BarEquations::Part part : components_.parts()) {
      equations_.gather(part, call.positions);
      const BarEquations::Errors errors = equations_.measure(part);
      if (!errors.finite) return Stop::not_finite;
      if (errors.whole) continue;
      Budget budget(options_);
      all_whole = solve(part, errors, call, budget, summary) && all_whole;
      if (budget.stopped_by_caller()) return Stop::stopped_by_caller;
    }
    return all_whole ? Stop::converged : finishing_sweeps_.resolve(call, summary);
  }

 private:
  bool solve(BarEquations::Part part, const BarEquations::Errors& errors, const ResolveCall& call,
             Budget& budget, ResolveSummary& summary) {
    const auto x = equations_.positions();
    std::copy(x.begin() + part.joints.begin, x.begin() + part.joints.end,
              broken_.begin() + part.joints.begin);
    if (errors.coincident) part_coincident_joints(part, call);
    const PartResult result =
        solver_->solve(part, broken_, call, [&] { return budget.may_go_on(); });
    equations_.scatter(part, call.positions);
    summary.sweeps = std::max(summary.sweeps, result.iterations);
    summary.projections += result.iterations * std::int64_t(part.bars.size());
    summary.dropped_bars += result.dropped_bars;
    summary.off_nearest = std::max(summary.off_nearest, result.off_nearest);
    return result.whole;
  }

  /// Bars without direction get one that the seed decides, and their length along it.
  void part_coincident_joints(BarEquations::Part part, const ResolveCall& call) {
    const auto x = equations_.positions();
    for (std::uint32_t k = part.bars.begin; k < part.bars.end; ++k) {
      auto [low, high] = equations_.ends(k);
      if (equations_.joint(low) > equations_.joint(high)) std::swap(low, high);
      const double sum = equations_.weight(low) + equations_.weight(high);
      if (!equations_.is_coincident(k) || !(sum > 0.0)) continue;
      RandomKey key = call.key;
      key.domain = Domain::escape;
      key.joint = equations_.bar(k);
      const Vec3 apart =
          (equations_.rest(k) / sum) * framework_.random_direction(RandomSequence(key));
      x[low] -= equations_.weight(low) * apart;
      x[high] += equations_.weight(high) * apart;
    }
  }

  const Framework& framework_;
  ResolveOptions options_;
  ComponentEquations components_;
  BarEquations& equations_;
  std::unique_ptr<PartSolver> solver_;
  std::vector<Vec3> broken_;  ///< of the joints of the equations
  FinishingSweeps finishing_sweeps_;
};

}  // namespace

ComponentEquations::ComponentEquations(const Framework& framework, const Tolerance& tolerance)
    : equations_(framework, inverse_masses(framework), tolerance) {
  for (const auto& bars : bars_of_components(framework)) {
    const auto part = equations_.append(bars);
    if (part) {
      parts_.push_back(*part);
    } else {
      entangled_ = true;
    }
  }
}

std::unique_ptr<Method> make_direct_method(const Framework& framework,
                                           const ResolveOptions& options, MakePartSolver make) {
  return std::make_unique<DirectMethod>(framework, options, make);
}

}  // namespace pliant
