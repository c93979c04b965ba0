// SPDX-License-Identifier: MIT
#include "pliant/resolve/lanes/lane_blocks.hpp"

#include "pliant/resolve/blocks/block_solver.hpp"
#include "pliant/resolve/blocks/outward_plan.hpp"
#include "pliant/resolve/method/plan_of_root.hpp"

namespace pliant {
namespace {

/// Bridges up to `end`, and then a block if there is one.
struct Stretch {
  std::size_t begin, end;
  std::uint32_t block;
  Joint entry;
};

class LaneBlocks final : public LaneMethod {
 public:
  explicit LaneBlocks(const LaneSetting& setting)
      : framework_(setting.framework),
        tolerance_(setting.options.tolerance),
        kernels_(setting.kernels),
        bars_(lane_bars(setting.framework, setting.options.tolerance)),
        planner_(setting.framework),
        blocks_(setting.framework, setting.technique, setting.options.tolerance,
                planner_.blocks()) {
    for (std::uint32_t block = 0; block < blocks_.count() && is_plain(); ++block)
      scratch_.fit(blocks_.pattern(block));
  }

  bool is_plain() const { return blocks_.holds_all() && !blocks_.any_overbraced(); }

  LaneEnds begin(const LaneCall& call) override {
    const LaneMask whole = find_whole(call, call.lanes);
    return {.whole = whole, .left = LaneMask(call.lanes & ~whole)};
  }

  LaneEnds go_on(const LaneCall& call, LaneMask left) override {
    planned_.prepare(call.root, [this](Joint root) { plan(root); });
    pass(call, left);
    // With several pinned joints bars between them are not free to follow.
    if (framework_.pinned_count() > 1) left = find_whole(call, left);
    return {.whole = left};
  }

 private:
  LaneMask find_whole(const LaneCall& call, LaneMask among) const {
    return kernels_.find_whole({bars_.data(), bars_.size()}, call.positions, among);
  }

  void plan(Joint root) {
    planner_.plan(root, outward_);
    bridges_.clear();
    stretches_.clear();
    std::size_t begin = 0;
    for (const OutwardStep& step : outward_) {
      if (step.block != no_block) {
        stretches_.push_back({begin, bridges_.size(), step.block, step.near});
        begin = bridges_.size();
      } else if (!framework_.is_pinned(step.far)) {
        const double rest = framework_.rest_lengths()[step.bar];
        bridges_.push_back(lane_bar(step.near, step.far, rest, tolerance_.of(rest)));
      }
    }
    stretches_.push_back({begin, bridges_.size(), no_block, 0});
    bridge_steps_ = static_cast<std::int64_t>(outward_.size() - (stretches_.size() - 1));
  }

  void pass(const LaneCall& call, LaneMask& active) {
    for (const Stretch& stretch : stretches_) {
      const LaneMask well = kernels_.carry(
          {bridges_.data() + stretch.begin, stretch.end - stretch.begin}, call.positions);
      active = LaneMask(active & well);
      if (stretch.block != no_block) solve(call, stretch, active);
    }
    call.each(active, [this](ResolveSummary& summary, std::size_t) {
      ++summary.sweeps;
      summary.projections += bridge_steps_;
    });
  }

  void solve(const LaneCall& call, const Stretch& stretch, LaneMask& active) {
    const BarPattern part = blocks_.hold(stretch.block, stretch.entry);
    const LaneResult result = kernels_.block_newton(part, scratch_.room(), call.positions);
    active = LaneMask(active & result.whole);
    call.each(active, [&](ResolveSummary& summary, std::size_t lane) {
      summary.dropped_bars += static_cast<std::int64_t>(result.dropped_bars[lane]);
      summary.projections +=
          (static_cast<std::int64_t>(result.iterations[lane]) + 1) * part.bars.size();
    });
  }

  const Framework& framework_;
  Tolerance tolerance_;
  const LaneKernels& kernels_;
  std::vector<LaneBar> bars_;
  OutwardPlanner planner_;
  BlockSolver blocks_;
  LaneScratch scratch_;
  std::vector<OutwardStep> outward_;
  std::vector<LaneBar> bridges_;
  std::vector<Stretch> stretches_;
  std::int64_t bridge_steps_ = 0;  ///< bridges to pinned joints included
  PlanOfRoot planned_;
};

}  // namespace

std::unique_ptr<LaneMethod> make_lane_blocks(const LaneSetting& setting) {
  auto method = std::make_unique<LaneBlocks>(setting);
  if (!method->is_plain()) return nullptr;
  return method;
}

}  // namespace pliant
