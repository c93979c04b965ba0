// SPDX-License-Identifier: MIT
#include "pliant/resolve/walkers.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/resolve/automatic.hpp"
#include "pliant/resolve/lanes/lane_method.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<std::string_view> names_of_levels() {
  std::vector<std::string_view> names;
  for (const LaneKernels* kernels : lane_levels()) names.push_back(kernels->level);
  return names;
}

const LaneKernels& find_level(std::string_view name) {
  std::string known;
  for (const LaneKernels* kernels : lane_levels()) {
    if (name.empty() || name == kernels->level) return *kernels;
    known += (known.empty() ? "" : ", ") + std::string(kernels->level);
  }
  throw OptionError("lane level = " + std::string(name) + ": must be one of " + known);
}

}  // namespace

std::span<const std::string_view> lane_level_names() {
  static const std::vector<std::string_view> names = names_of_levels();
  return names;
}

/// Up to eight walkers on their way through the lanes.
struct WalkerResolver::Plan final : LaneEnd {
  const Framework& framework;
  Technique technique;
  ResolveOptions options;
  const LaneKernels& kernels;
  Resolver alone;
  bool uses_lanes;
  Measured measured = Measured::max_residual;
  std::unique_ptr<LaneMethod> method;  ///< null: no lanes, or not yet
  std::vector<LaneBar> bars;
  std::vector<LaneVector> positions, reference;
  std::span<const WalkerPositions> group;
  ResolveSummary summaries[lane_count];
  LaneMask finished = 0;

  Plan(const Framework& framework_, const Technique& asked, const ResolveOptions& options_,
       const LaneOptions& lanes)
      : framework(framework_),
        technique(technique_used(framework_, asked)),
        options(options_),
        kernels(find_level(lanes.level)),
        alone(framework_, asked, options_),
        uses_lanes(lanes.lanes && framework_.has_bars_only() &&
                   find_technique(technique.name).make_lanes != nullptr) {}

  /// A single walker never needs the lanes' plans and memory.
  bool prepare_lanes() {
    if (method || !uses_lanes) return uses_lanes;
    method = find_technique(technique.name).make_lanes({framework, technique, options, kernels});
    uses_lanes = method != nullptr;
    if (uses_lanes) bars = lane_bars(framework, options.tolerance);
    return uses_lanes;
  }

  void resolve_alone(const WalkerPositions& walker, ResolveSummary& summary, Joint root,
                     std::int64_t step) {
    alone.set_walker(walker.walker);
    summary = alone.resolve(walker.positions, root, step, walker.reference);
    if (measured != Measured::rms_residual) summary.rms_residual = -1.0;
    if (measured == Measured::nothing) summary.max_residual = -1.0, summary.worst_bar = 0;
  }

  void resolve_group(std::span<const WalkerPositions> walkers, std::span<ResolveSummary> out,
                     Joint root, std::int64_t step) {
    const auto start = Clock::now();
    group = walkers;
    finished = 0;
    gather();
    for (ResolveSummary& summary : summaries) {
      summary = {};
      summary.sweeps = summary.projections = 0;
      summary.dropped_bars = summary.finishing_sweeps = 0;
    }
    const auto lanes = static_cast<LaneMask>((1u << walkers.size()) - 1);
    method->resolve({positions.data(), reference.empty() ? nullptr : reference.data(), root, lanes,
                     summaries, *this});
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    for (std::size_t lane = 0; lane < walkers.size(); ++lane) {
      out[lane] = summaries[lane];
      out[lane].seconds = seconds / double(walkers.size());
      if (!(finished >> lane & 1)) resolve_alone(walkers[lane], out[lane], root, step);
    }
  }

  /// Lanes without a walker repeat the first one's.
  void gather() {
    const double* rows[lane_count];
    const auto row_of = [](std::span<const Vec3> of) {
      return reinterpret_cast<const double*>(of.data());
    };
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      rows[lane] = row_of(group[lane < group.size() ? lane : 0].positions);
    positions.resize(framework.joint_count());
    gather(rows, positions);
    reference.resize(method->needs_reference() ? group[0].reference.size() : 0);
    if (reference.empty()) return;
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      rows[lane] = row_of(group[lane < group.size() ? lane : 0].reference);
    gather(rows, reference);
  }

  void gather(const double* const* rows, std::vector<LaneVector>& out) const {
    kernels.gather(rows, 3 * out.size(), reinterpret_cast<LaneValue*>(out.data()));
  }

  /// As measure() does.
  double rms_of(const LaneResiduals& found, std::size_t lane) const {
    if (bars.empty()) return 0.0;
    return std::min(std::sqrt(found.sum_of_squares[lane] / double(bars.size())),
                    found.max_relative[lane]);
  }

  /// Lengths that are not finite, and walkers that were believed whole, are looked at alone.
  void finish(LaneMask lanes, Stop stop) override {
    if (measured == Measured::nothing && stop == Stop::converged)
      return publish(LaneMask(lanes & kernels.confirm_whole(bar_list(), positions.data())), stop);
    const LaneResiduals found =
        kernels.measure(bar_list(), positions.data(), measured == Measured::rms_residual);
    lanes = LaneMask(lanes & found.finite);
    if (stop == Stop::converged) lanes = LaneMask(lanes & found.within);
    publish(lanes, stop);
    if (measured != Measured::nothing) note(found, lanes);
  }

  void finish_whole(LaneMask lanes) override {
    measured == Measured::nothing ? publish(lanes, Stop::converged)
                                  : finish(lanes, Stop::converged);
  }

  LaneList<LaneBar> bar_list() const { return {bars.data(), bars.size()}; }

  void note(const LaneResiduals& found, LaneMask lanes) {
    for (std::size_t lane = 0; lane < group.size(); ++lane) {
      if (!(lanes >> lane & 1)) continue;
      summaries[lane].max_residual = found.max_relative[lane];
      summaries[lane].worst_bar = found.worst_bar[lane];
      if (measured == Measured::rms_residual) summaries[lane].rms_residual = rms_of(found, lane);
    }
  }

  /// The walkers of these lanes are where they end.
  void publish(LaneMask lanes, Stop stop) {
    double* rows[lane_count] = {};
    for (std::size_t lane = 0; lane < group.size(); ++lane) {
      if (!(lanes >> lane & 1)) continue;
      rows[lane] = reinterpret_cast<double*>(group[lane].positions.data());
      summaries[lane].stop = stop;
    }
    kernels.scatter(reinterpret_cast<const LaneValue*>(positions.data()), 3 * positions.size(),
                    rows);
    finished = LaneMask(finished | lanes);
  }
};

WalkerResolver::WalkerResolver(const Framework& framework, const Technique& technique,
                               const ResolveOptions& options, const LaneOptions& lanes)
    : plan_(std::make_unique<Plan>(framework, technique, options, lanes)) {}

WalkerResolver::~WalkerResolver() = default;
WalkerResolver::WalkerResolver(WalkerResolver&&) noexcept = default;

std::string_view WalkerResolver::level() {
  return plan_->prepare_lanes() ? plan_->kernels.level : std::string_view();
}

Resolver& WalkerResolver::alone() { return plan_->alone; }

void WalkerResolver::resolve(std::span<const WalkerPositions> walkers,
                             std::span<ResolveSummary> summaries, Joint root, std::int64_t step,
                             Measured measured) {
  plan_->measured = measured;
  if (summaries.size() != walkers.size())
    throw OptionError("summaries: " + std::to_string(summaries.size()) + " for " +
                      std::to_string(walkers.size()) + " walkers");
  for (const WalkerPositions& walker : walkers)
    plan_->alone.check_arguments(walker.positions, root, walker.reference);
  for (std::size_t at = 0; at < walkers.size(); at += lane_count) {
    const std::size_t count = std::min(lane_count, walkers.size() - at);
    const auto group = walkers.subspan(at, count);
    if (at > 0 && plan_->options.should_stop && plan_->options.should_stop()) {
      ResolveSummary not_begun;
      not_begun.seconds = 0.0;  // callers add them up
      std::fill(summaries.begin() + std::ptrdiff_t(at), summaries.end(), not_begun);
      return;
    }
    const bool alike = std::all_of(group.begin(), group.end(), [&](const WalkerPositions& walker) {
      return walker.reference.size() == group[0].reference.size();
    });
    if (count > 1 && alike && plan_->prepare_lanes()) {
      plan_->resolve_group(group, summaries.subspan(at, count), root, step);
    } else {
      for (std::size_t k = at; k < at + count; ++k)
        plan_->resolve_alone(walkers[k], summaries[k], root, step);
    }
  }
}

}  // namespace pliant
