// SPDX-License-Identifier: MIT
// Sampler `pocket`: frames that open or close one place.
#include <utility>

#include "pliant/base/random.hpp"
#include "pliant/sample/loops/loop_moves.hpp"
#include "pliant/sample/modes_sampler.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/pocket/pocket.hpp"
#include "pliant/sample/pocket/pocket_turns.hpp"
#include "pliant/sample/pocket/side_chain_moves.hpp"
#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/samplers.hpp"
#include "pliant/sample/turns/course_measures.hpp"

namespace pliant {
namespace {

constexpr int attempts_at_half = 2;     // after so many attempts in vain moves are half as large
constexpr int attempts_at_pocket = 12;  // after so many only the modes move

/// (M) which nodes have joints of a place.
std::vector<bool> nodes_in(const Pocket& place, const std::vector<std::uint32_t>& of_joint,
                           std::size_t count) {
  std::vector<bool> in_place(count, false);
  for (std::size_t k = 0; k < of_joint.size(); ++k)
    if (place.has_joint[k]) in_place[of_joint[k]] = true;
  return in_place;
}

/// Of the atom table; all if there is none.
std::vector<bool> residues_in(const Pocket& place, const Framework& framework) {
  if (framework.atoms() == nullptr) return {};
  std::vector<bool> in_place(framework.atoms()->residues.size(), false);
  for (const std::uint32_t residue : place.residues) in_place[residue] = true;
  return in_place;
}

/// Side chains of the place are redrawn from rotamers, segments and domains beside it turn, or
/// loops that touch it are redrawn, and all goes along a draw of the modes. Contacts that this
/// would tear are let go.
class PocketSampler final : public Sampler {
 public:
  explicit PocketSampler(const SamplerSetting& setting);
  PocketSampler(const SamplerSetting& setting, const NetworkModes& modes);

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           FrameRequest& request) const override;

 private:
  void turn(const DrawnTurns& turned, const std::vector<Vec3>& moves, FrameRequest& request) const;
  void redraw_loops(std::int64_t frame, int attempt, std::vector<Vec3>& x) const;
  void let_go(std::span<const Vec3> without_modes, FrameRequest& request) const;

  const Framework& framework_;
  std::span<const Vec3> start_;
  const NetworkNodes& nodes_;
  std::vector<std::uint32_t> of_joint_;
  Pocket place_;
  PocketTurns turns_;
  LoopMoves loops_;
  SideChainMoves side_chains_;
  ModesSampler modes_;
  std::uint64_t seed_;
};

PocketSampler::PocketSampler(const SamplerSetting& setting)
    : PocketSampler(setting, network_modes(setting)) {}

PocketSampler::PocketSampler(const SamplerSetting& setting, const NetworkModes& modes)
    : framework_(setting.framework),
      start_(setting.start),
      nodes_(setting.nodes),
      of_joint_(nodes_of_joints(setting.nodes, setting.start)),
      place_(pocket_around(framework_, start_, setting.options.around_joints)),
      turns_(nodes_, modes, nodes_in(place_, of_joint_, nodes_.positions.size())),
      loops_(framework_, setting.plan, start_, residues_in(place_, framework_)),
      side_chains_(framework_, setting.plan, start_, place_),
      modes_(setting, modes),
      seed_(setting.options.seed) {}

void PocketSampler::ask(std::int64_t frame, int, int attempt, std::span<const Vec3>,
                        FrameRequest& request) const {
  RandomSequence draws({seed_, Domain::pocket, static_cast<std::uint64_t>(attempt),
                        static_cast<std::uint64_t>(frame), 0});
  std::vector<Vec3> moves(start_.size());
  modes_.displace(frame, attempt, moves);
  request.from.assign(start_.begin(), start_.end());
  request.course = {};
  request.drawn_by = DrawnBy::pocket;
  DrawnTurns turned;
  if (attempt < attempts_at_pocket) {
    const double scale = double(attempts_at_half) / double(attempts_at_half + attempt);
    side_chains_.redraw(draws, scale * draws.uniform(), request.from);
    turned = turns_.draw(draws, scale);
    if (turned.tree == nullptr) redraw_loops(frame, attempt, request.from);
  }
  turn(turned, moves, request);
}

void PocketSampler::redraw_loops(std::int64_t frame, int attempt, std::vector<Vec3>& x) const {
  if (attempt >= attempts_at_loops) return;
  RandomSequence draws({seed_, Domain::loop, static_cast<std::uint64_t>(attempt),
                        static_cast<std::uint64_t>(frame), 0});
  loops_.redraw(draws, most_loops, x);
}

/// The way from where side chains were redrawn.
void PocketSampler::turn(const DrawnTurns& turned, const std::vector<Vec3>& moves,
                         FrameRequest& request) const {
  request.targets = request.from;
  std::vector<Vec3> without_modes = request.from;
  if (turned.tree == nullptr) {
    for (std::size_t k = 0; k < moves.size(); ++k) request.targets[k] += moves[k];
    return let_go(without_modes, request);
  }
  request.course = course_of(nodes_, of_joint_, turned, request.from, moves);
  request.course.at(1.0, request.targets);
  const std::vector<Vec3> still(moves.size());
  course_of(nodes_, of_joint_, turned, request.from, still).at(1.0, without_modes);
  let_go(without_modes, request);
}

/// What redrawn side chains and turns would tear; of the place what the modes would tear, too.
void PocketSampler::let_go(std::span<const Vec3> without_modes, FrameRequest& request) const {
  request.limits_off = torn_limits(framework_, without_modes);
  const std::vector<std::uint8_t> torn = torn_limits(framework_, request.targets);
  const auto limits = framework_.limits();
  for (std::size_t k = 0; k < torn.size(); ++k)
    if (place_.has_joint[limits[k].a] || place_.has_joint[limits[k].b])
      request.limits_off[k] |= torn[k];
}

}  // namespace

std::unique_ptr<Sampler> make_pocket_sampler(const SamplerSetting& setting) {
  return std::make_unique<PocketSampler>(setting);
}

}  // namespace pliant
