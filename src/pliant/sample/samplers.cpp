// SPDX-License-Identifier: MIT
#include "pliant/sample/samplers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "pliant/base/choices.hpp"
#include "pliant/base/math/elementary.hpp"
#include "pliant/base/random.hpp"
#include "pliant/conformers/torsions/small_sterics.hpp"
#include "pliant/conformers/torsions/torsion_moves.hpp"
#include "pliant/resolve/froda/bodies/body_plan.hpp"
#include "pliant/sample/modes_sampler.hpp"
#include "pliant/sample/pocket_sampler.hpp"
#include "pliant/sample/reach_sampler.hpp"
#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/turns_sampler.hpp"

namespace pliant {
namespace {

constexpr double walk_length = 0.1;    // Angstrom, a random move of a node
constexpr double walk_momentum = 0.8;  // share of the last move that is made again
constexpr int walk_steps = 20;         // from frame to frame

/// The same with contacts off by chance, the weaker the more often.
class DiluteSampler final : public ModesSampler {
 public:
  explicit DiluteSampler(const SamplerSetting& setting)
      : ModesSampler(setting),
        limits_(setting.framework.limits()),
        seed_(setting.options.seed),
        contact_energy_(setting.options.contact_energy * kj_per_kcal) {}

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           std::span<const Vec3> before, FrameRequest& request) const override {
    ModesSampler::ask(frame, step, attempt, now, before, request);
    request.limits_off.assign(limits_.size(), 0);
    for (std::size_t k = 0; k < limits_.size(); ++k)
      request.limits_off[k] = is_off(frame, attempt, k);
  }

 private:
  /// Limits of one group are on or off together; those of no known energy stay on.
  std::uint8_t is_off(std::int64_t frame, int attempt, std::size_t limit) const {
    const Limit& at = limits_[limit];
    if (at.energy == 0.0) return 0;
    const bool alone = at.group == no_limit_group;
    const std::uint64_t thing = alone ? limit : at.group;
    RandomSequence draws({seed_, Domain::dilution, static_cast<std::uint64_t>(attempt),
                          static_cast<std::uint64_t>(frame), thing + (alone ? 1ull << 32 : 0)});
    return draws.uniform() < exact_bits_exp(-std::abs(at.energy) / contact_energy_) ? 1 : 0;
  }

  std::span<const Limit> limits_;
  std::uint64_t seed_;
  double contact_energy_;  ///< kJ/mol, as energies of limits are
};

/// Each node goes a little way at random, and goes on as it went.
class WalkSampler final : public Sampler {
 public:
  explicit WalkSampler(const SamplerSetting& setting)
      : of_joint_(setting.nodes.of_joint),
        nodes_(setting.nodes.positions.size()),
        seed_(setting.options.seed),
        length_(walk_length * setting.options.amplitude / usual_amplitude) {}

  bool is_walk() const override { return true; }
  int steps_a_frame() const override { return walk_steps; }

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           std::span<const Vec3> before, FrameRequest& request) const override {
    std::vector<Vec3> moves(nodes_);
    const auto number = static_cast<std::uint64_t>(frame * walk_steps + step);
    random_directions({seed_, Domain::walk, static_cast<std::uint64_t>(attempt), number, 0}, false,
                      moves);
    request.targets.assign(now.begin(), now.end());
    request.limits_off.clear();
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (of_joint_[k] != no_node) request.targets[k] += length_ * moves[of_joint_[k]];
      if (attempt == 0) request.targets[k] += walk_momentum * (now[k] - before[k]);
    }
  }

 private:
  std::vector<std::uint32_t> of_joint_;
  std::size_t nodes_;
  std::uint64_t seed_;
  double length_;
};

/// Of so many draws the one that overlaps least is resolved: torsions stay where they were drawn.
constexpr int draws_a_conformer = 20;
constexpr double little_overlap = 0.1;  // Angstrom^2: resolving takes it away

/// Flexible loops that cannot be drawn are bent so often.
constexpr int loop_steps = 12;

/// Conformers: torsions drawn, rings given a form, loops drawn and closed. The torsions of three of
/// four frames are those that are usual, of the fourth any: starts of one conformer each miss what
/// the other finds.
class TorsionsSampler final : public Sampler {
 public:
  explicit TorsionsSampler(const SamplerSetting& setting)
      : moves_(setting.framework, setting.plan, setting.start, conformer_moves(setting.options)),
        sterics_(setting.framework),
        seed_(setting.options.seed) {
    if (moves_.empty())
      setting.options.log.warn(
          "no bond can rotate and no ring has another form: all conformers are the same");
  }

  int steps_a_frame() const override { return moves_.bent() != nullptr ? loop_steps : 1; }

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           std::span<const Vec3>, FrameRequest& request) const override {
    RandomSequence draws({seed_, Domain::torsion, static_cast<std::uint64_t>(attempt),
                          static_cast<std::uint64_t>(frame), static_cast<std::uint64_t>(step)});
    request.limits_off.clear();
    request.from.assign(now.begin(), now.end());
    if (step == 0) {
      const bool is_usual = frame % 4 != 3;
      draw(draws, is_usual ? TorsionDraw::preferred : TorsionDraw::uniform, request);
    }
    request.targets = request.from;
    if (moves_.bent() != nullptr) moves_.bent()->push(draws, request.targets);
  }

 private:
  /// Of several draws of the torsions, the rings as they are, the one that overlaps least.
  void draw(RandomSequence& draws, TorsionDraw how, FrameRequest& request) const {
    moves_.draw_rings(draws, request.from);
    moves_.draw_amines(draws, request.from);
    moves_.draw_amides(draws, request.from);
    moves_.draw_loops(draws, how, request.from);
    const std::vector<Vec3> start = request.from;
    double least = HUGE_VAL;
    for (int k = 0; k < draws_a_conformer && least > little_overlap; ++k) {
      request.targets = start;
      moves_.turn_rotors(draws, how, request.targets);
      const double here = sterics_.overlap(request.targets);
      if (!(here < least)) continue;
      least = here;
      request.from.swap(request.targets);
    }
  }

  TorsionMoves moves_;
  SmallSterics sterics_;
  std::uint64_t seed_;
};

template <class Made>
std::unique_ptr<Sampler> make(const SamplerSetting& setting) {
  return std::make_unique<Made>(setting);
}

constexpr SamplerEntry table[] = {
    {"modes", "independent frames along the modes of an elastic network", make<ModesSampler>},
    {"dilute", "the same, with each contact off with probability exp(-|E| / X)",
     make<DiluteSampler>},
    {"turns", "domains turned as wholes about the links that join them", make<TurnsSampler>},
    {"reach", "modes for the first half of the frames, then wide modes, and turns",
     make<ReachSampler>},
    {"pocket", "side chains, segments and domains about one site (--around) opened or closed",
     make<PocketSampler>},
    {"walk", "a random walk of residues with momentum (plain FRODA)", make<WalkSampler>},
    {"torsions", "conformers of small molecules: torsions, forms of rings, large rings closed",
     make<TorsionsSampler>, false}};

/// Of more all at once drawn, hardly any draw is free of overlaps.
constexpr std::size_t most_rotors = 64;
constexpr std::size_t most_atoms = 2000;

}  // namespace

std::span<const SamplerEntry> samplers() { return table; }

std::string_view usual_sampler(const Framework& framework, std::span<const Vec3> start,
                               bool has_residues) {
  if (has_residues || start.size() > most_atoms) return "modes";
  const std::optional<BodyPlan> plan = conformer_plan(framework, start);
  if (!plan) return "modes";
  const auto is_free = [](const PlanBody& body) { return body.parent < 0; };
  const auto bodies = plan->bodies();
  if (std::count_if(bodies.begin(), bodies.end(), is_free) > 1) return "modes";
  const TorsionMoves moves(framework, *plan, start);
  return moves.rotors().size() > most_rotors ? "modes" : "torsions";
}

ConformerMoves conformer_moves(const SampleOptions& options) {
  return {.secondary_amides = options.turn_amides, .ring_systems = options.ring_systems};
}

const SamplerEntry& find_sampler(std::string_view name) {
  return choose(samplers(), "sampler", name);
}

}  // namespace pliant
