// SPDX-License-Identifier: MIT
// Sampler `pocket`: frames that open or close one place.
#include <algorithm>
#include <utility>

#include "pliant/base/random.hpp"
#include "pliant/sample/loops/loop_moves.hpp"
#include "pliant/sample/modes_sampler.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/pocket/held_contacts.hpp"
#include "pliant/sample/pocket/ligand_moves.hpp"
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
constexpr int most_poses = 6;           // of ligands, until side chains have made room

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

std::vector<std::uint8_t> held_in(const Pocket& place, const BondChemistry& chemistry,
                                  const Framework& framework, const SampleOptions& options) {
  if (place.ligand.empty()) return {};
  std::vector<bool> is_ligand(framework.joint_count(), false);
  for (const Joint joint : place.ligand) is_ligand[joint] = true;
  return held_contacts(framework, chemistry, is_ligand, options.hold);
}

/// The residues of contacts that are held.
std::vector<std::uint32_t> residues_of(const std::vector<std::uint8_t>& held,
                                       const Framework& framework) {
  std::vector<std::uint32_t> out;
  for (std::size_t k = 0; k < held.size(); ++k)
    for (const Joint joint : {framework.limits()[k].a, framework.limits()[k].b})
      if (held[k] != 0) out.push_back(framework.atoms()->residue_of[joint]);
  return out;
}

std::vector<bool> turned_by(const SideChainMoves& side_chains, std::size_t joints) {
  std::vector<bool> out(joints, false);
  for (const SideChain& one : side_chains.side_chains())
    for (const Joint joint : one.torsions.front().turning) out[joint] = true;
  return out;
}

/// Side chains of the place are redrawn from rotamers, segments and domains beside it turn, or
/// loops that touch it are redrawn, and all goes along a draw of the modes. A ligand gets other
/// torsions first, and side chains make room. Contacts that this would tear are let go, but for
/// those of the ligand that are held.
class PocketSampler final : public Sampler {
 public:
  explicit PocketSampler(const SamplerSetting& setting);
  PocketSampler(const SamplerSetting& setting, const NetworkModes& modes);

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           FrameRequest& request) const override;

 private:
  void draw_side_chains(RandomSequence& draws, double share, FrameRequest& request) const;
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
  BondChemistry chemistry_;
  std::vector<std::uint8_t> held_;  ///< (L), or empty
  SideChainMoves side_chains_;
  LigandMoves ligand_;
  ModesSampler modes_;
  double nearness_;  ///< 1 with the usual amplitude and beyond; turns and loops go less far below
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
      chemistry_(framework_, start_),
      held_(held_in(place_, chemistry_, framework_, setting.options)),
      side_chains_(framework_, setting.plan, start_, place_, residues_of(held_, framework_)),
      ligand_(framework_, setting.plan, start_, place_.ligand, chemistry_, held_,
              turned_by(side_chains_, start_.size())),
      modes_(setting, modes),
      nearness_(std::min(1.0, setting.options.amplitude / usual_amplitude)),
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
    draw_side_chains(draws, scale * draws.uniform(), request);
    turned = turns_.draw(draws, scale * nearness_);
    if (turned.tree == nullptr && (nearness_ == 1.0 || draws.uniform() < nearness_))
      redraw_loops(frame, attempt, request.from);
  }
  turn(turned, moves, request);
}

void PocketSampler::draw_side_chains(RandomSequence& draws, double share,
                                     FrameRequest& request) const {
  for (int k = 0; k < most_poses && !ligand_.molecules().empty(); ++k) {
    std::vector<Vec3> x = request.from;
    if (!ligand_.redraw(draws, x)) continue;
    side_chains_.make_room(draws, share, x);
    if (!ligand_.fits(x)) continue;
    request.from.swap(x);
    request.drawn_by = DrawnBy::ligand;
    return;
  }
  side_chains_.redraw(draws, share, request.from);
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

/// What redrawn side chains and turns would tear; of the place what the modes would tear, too. A
/// ligand goes with what it has after its torsions and side chains were drawn.
void PocketSampler::let_go(std::span<const Vec3> without_modes, FrameRequest& request) const {
  request.limits_off = torn_limits(framework_, without_modes);
  const std::vector<std::uint8_t> torn = torn_limits(framework_, request.targets);
  const auto limits = framework_.limits();
  for (std::size_t k = 0; k < torn.size(); ++k)
    if (place_.has_joint[limits[k].a] || place_.has_joint[limits[k].b])
      request.limits_off[k] |= torn[k];
  if (ligand_.molecules().empty()) return;
  const std::vector<std::uint8_t> drawn = torn_limits(framework_, request.from);
  for (const LigandMolecule& molecule : ligand_.molecules())
    for (const LimitIndex k : molecule.contacts) request.limits_off[k] = drawn[k];
  for (std::size_t k = 0; k < held_.size(); ++k)
    if (held_[k] != 0) request.limits_off[k] = 0;
}

}  // namespace

std::unique_ptr<Sampler> make_pocket_sampler(const SamplerSetting& setting) {
  return std::make_unique<PocketSampler>(setting);
}

}  // namespace pliant
