// SPDX-License-Identifier: MIT
#include "pliant/resolve/walkers.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/resolve/auto.hpp"
#include "pliant/resolve/lanes/lane_group.hpp"
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

bool have_like_references(std::span<const WalkerPositions> walkers) {
  return std::all_of(walkers.begin(), walkers.end(), [&](const WalkerPositions& walker) {
    return walker.reference.size() == walkers[0].reference.size();
  });
}

/// The summary of a walker that stays where it is.
ResolveSummary not_begun() {
  ResolveSummary summary;
  summary.seconds = 0.0;  // callers add them up
  return summary;
}

}  // namespace

std::span<const std::string_view> lane_level_names() {
  static const std::vector<std::string_view> names = names_of_levels();
  return names;
}

/// The resolver of one walker, and the lanes once they are needed.
struct WalkerResolver::LanePlan {
  const Framework& framework;
  Technique technique;
  ResolveOptions options;
  const LaneKernels& kernels;
  Resolver alone;
  bool uses_lanes;
  std::optional<LaneGroup> lanes;

  LanePlan(const Framework& framework_, const Technique& asked, const ResolveOptions& options_,
           const LaneOptions& lane_options)
      : framework(framework_),
        technique(technique_used(framework_, asked)),
        options(options_),
        kernels(find_level(lane_options.level)),
        alone(framework_, asked, options_),
        uses_lanes(lane_options.lanes && !options.on_bar && framework_.has_bars_only() &&
                   entry_of(technique).make_lanes != nullptr && !shifts_to_mass_centre(technique)) {
  }

  /// A single walker never needs the lanes' plans and memory.
  bool prepare_lanes() {
    if (lanes || !uses_lanes) return uses_lanes;
    const LaneSetting setting{framework, technique, options, kernels};
    auto method = entry_of(technique).make_lanes(setting);
    uses_lanes = method != nullptr;
    if (uses_lanes) lanes.emplace(framework, options.tolerance, kernels, std::move(method));
    return uses_lanes;
  }

  /// What is asked of all walkers of a call.
  struct Asked {
    Joint root;
    std::int64_t step;
    Measured measured;
  };

  void resolve(std::span<const WalkerPositions> walkers, std::span<ResolveSummary> summaries,
               const Asked& asked) {
    if (walkers.size() > 1 && have_like_references(walkers) && prepare_lanes())
      return resolve_in_lanes(walkers, summaries, asked);
    for (std::size_t k = 0; k < walkers.size(); ++k)
      summaries[k] = resolve_alone(walkers[k], asked);
  }

  void resolve_in_lanes(std::span<const WalkerPositions> walkers,
                        std::span<ResolveSummary> summaries, const Asked& asked) {
    const auto start = Clock::now();
    const LaneMask ended = lanes->resolve(walkers, summaries, asked.root, asked.measured);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    for (std::size_t lane = 0; lane < walkers.size(); ++lane) {
      summaries[lane].seconds = seconds / double(walkers.size());
      if (!(ended >> lane & 1)) summaries[lane] = resolve_alone(walkers[lane], asked);
    }
  }

  ResolveSummary resolve_alone(const WalkerPositions& walker, const Asked& asked) {
    alone.set_walker(walker.walker);
    alone.set_limits_off(walker.limits_off);
    ResolveSummary summary =
        alone.resolve(walker.positions, asked.root, asked.step, walker.reference);
    if (asked.measured != Measured::rms_residual) summary.rms_residual = -1.0;
    if (asked.measured == Measured::nothing) {
      summary.max_residual = -1.0;
      summary.worst_bar = 0;
    }
    return summary;
  }

  bool is_asked_to_stop() const { return options.should_stop && options.should_stop(); }
};

WalkerResolver::WalkerResolver(const Framework& framework, const Technique& technique,
                               const ResolveOptions& options, const LaneOptions& lanes)
    : plan_(std::make_unique<LanePlan>(framework, technique, options, lanes)) {}

WalkerResolver::~WalkerResolver() = default;
WalkerResolver::WalkerResolver(WalkerResolver&&) noexcept = default;

bool WalkerResolver::may_use_lanes() const { return plan_->uses_lanes; }

std::string_view WalkerResolver::level() {
  return plan_->prepare_lanes() ? plan_->kernels.level : std::string_view();
}

Resolver& WalkerResolver::alone() { return plan_->alone; }

void WalkerResolver::resolve(std::span<const WalkerPositions> walkers,
                             std::span<ResolveSummary> summaries, Joint root, std::int64_t step,
                             Measured measured) {
  if (summaries.size() != walkers.size())
    throw OptionError("summaries: " + std::to_string(summaries.size()) + " for " +
                      std::to_string(walkers.size()) + " walkers");
  for (const WalkerPositions& walker : walkers)
    plan_->alone.check_arguments(walker.positions, {root}, walker.reference);
  for (std::size_t at = 0; at < walkers.size(); at += lane_count) {
    if (at > 0 && plan_->is_asked_to_stop()) {
      std::fill(summaries.begin() + std::ptrdiff_t(at), summaries.end(), not_begun());
      return;
    }
    const std::size_t count = std::min(lane_count, walkers.size() - at);
    plan_->resolve(walkers.subspan(at, count), summaries.subspan(at, count),
                   {root, step, measured});
  }
}

}  // namespace pliant
