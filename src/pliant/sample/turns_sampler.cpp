// SPDX-License-Identifier: MIT
#include "pliant/sample/turns_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/random.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/sample_options.hpp"

namespace pliant {
namespace {

/// A contact that a turn would carry further out of its interval is let go (Angstrom).
constexpr double most_stretch = 1.0;
constexpr int measured_shares = 8;  // of a course, for its length

}  // namespace

TurnsSampler::TurnsSampler(const SamplerSetting& setting)
    : TurnsSampler(setting, network_modes(setting.nodes, setting.options.network)) {}

TurnsSampler::TurnsSampler(const SamplerSetting& setting, const NetworkModes& modes)
    : framework_(setting.framework),
      start_(setting.start),
      nodes_(setting.nodes),
      draws_(setting.nodes, modes),
      of_joint_(nodes_of_joints(setting.nodes, setting.start)),
      seed_(setting.options.seed) {
  if (draws_.empty() && setting.options.sampler == "turns") {
    setting.options.log.warn(
        "sampler turns: the molecule has no two parts that could turn against each other; its "
        "frames are those of sampler modes");
    modes_ = std::make_unique<ModesSampler>(setting, modes);
  }
}

void TurnsSampler::ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
                       std::span<const Vec3> before, FrameRequest& request) const {
  if (modes_) return modes_->ask(frame, step, attempt, now, before, request);
  ask_with({}, frame, attempt, request);
}

void TurnsSampler::ask_with(std::vector<Vec3> displacements, std::int64_t frame, int attempt,
                            FrameRequest& request) const {
  RandomSequence draws({seed_, Domain::turn, static_cast<std::uint64_t>(attempt),
                        static_cast<std::uint64_t>(frame), 0});
  const DrawnTurns drawn = draws_.draw(draws);
  request.targets.assign(start_.begin(), start_.end());
  request.limits_off.clear();
  request.course = {};
  request.drawn_by = displacements.empty() ? DrawnBy::turns : DrawnBy::turns_with_modes;
  if (drawn.tree == nullptr) return;
  displacements.resize(start_.size());
  request.course.at = [this, drawn, course = TurnCourse(nodes_, *drawn.tree),
                       moves = std::move(displacements)](double share,
                                                         std::span<Vec3> out) mutable {
    const auto motions = course.motions(drawn.turns, share);
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = motions[of_joint_[k]](start_[k] + share * moves[k]);
  };
  request.course.length = length_of(request.course);
  request.course.at(1.0, request.targets);
  let_go(request);
}

/// The longest way of a joint, by straight pieces.
double TurnsSampler::length_of(const Course& course) const {
  std::vector<Vec3> before(start_.begin(), start_.end()), now(start_.size());
  std::vector<double> ways(start_.size(), 0.0);
  for (int k = 1; k <= measured_shares; ++k) {
    course.at(double(k) / measured_shares, now);
    for (std::size_t j = 0; j < now.size(); ++j) ways[j] += distance(before[j], now[j]);
    before.swap(now);
  }
  return *std::max_element(ways.begin(), ways.end());
}

/// Contacts between pieces that move apart; one of several limits goes as a whole.
void TurnsSampler::let_go(FrameRequest& request) const {
  const auto limits = framework_.limits();
  request.limits_off.assign(limits.size(), 0);
  std::vector<std::uint32_t> gone;
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const double length = distance(request.targets[limits[k].a], request.targets[limits[k].b]);
    if (!(std::abs(excess(limits[k], length)) > most_stretch)) continue;
    request.limits_off[k] = 1;
    if (limits[k].group != no_limit_group) gone.push_back(limits[k].group);
  }
  std::sort(gone.begin(), gone.end());
  for (std::size_t k = 0; k < limits.size(); ++k)
    if (std::binary_search(gone.begin(), gone.end(), limits[k].group)) request.limits_off[k] = 1;
}

}  // namespace pliant
