// SPDX-License-Identifier: MIT
#include "pliant/sample/turns_sampler.hpp"

#include <memory>
#include <utility>

#include "pliant/base/random.hpp"
#include "pliant/sample/modes_sampler.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/samplers.hpp"
#include "pliant/sample/turns/course_measures.hpp"

namespace pliant {

TurnsSampler::TurnsSampler(const SamplerSetting& setting, const NetworkModes& modes)
    : framework_(setting.framework),
      start_(setting.start),
      nodes_(setting.nodes),
      draws_(setting.nodes, modes),
      of_joint_(nodes_of_joints(setting.nodes, setting.start)),
      seed_(setting.options.seed) {}

void TurnsSampler::ask(std::int64_t frame, int, int attempt, std::span<const Vec3>,
                       FrameRequest& request) const {
  RandomSequence draws({seed_, Domain::turn, static_cast<std::uint64_t>(attempt),
                        static_cast<std::uint64_t>(frame), 0});
  const DrawnTurns drawn = draws_.draw(draws);
  request.targets.assign(start_.begin(), start_.end());
  request.limits_off.clear();
  request.course = {};
  request.drawn_by = DrawnBy::turns;
  if (drawn.tree == nullptr) return;
  request.course =
      course_of(nodes_, of_joint_, drawn, request.targets, std::vector<Vec3>(start_.size()));
  request.course.at(1.0, request.targets);
  request.limits_off = torn_limits(framework_, request.targets);  // of pieces that move apart
}

/// If a molecule has no domains, its frames are those of `modes`, with a warning.
std::unique_ptr<Sampler> make_turns_sampler(const SamplerSetting& setting) {
  NetworkModes modes = network_modes(setting);
  auto turns = std::make_unique<TurnsSampler>(setting, modes);
  if (!turns->empty()) return turns;
  setting.options.log.warn(
      "sampler turns: the molecule has no two parts that could turn against each other; its "
      "frames are those of sampler modes");
  return std::make_unique<ModesSampler>(setting, std::move(modes));
}

}  // namespace pliant
