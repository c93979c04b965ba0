// SPDX-License-Identifier: MIT
// Sampler `torsions`.
#include <cmath>
#include <utility>

#include "pliant/base/random.hpp"
#include "pliant/conformers/torsions/small_sterics.hpp"
#include "pliant/conformers/torsions/torsion_moves.hpp"
#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant {
namespace {

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
           FrameRequest& request) const override {
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
      const double here = sterics_.overlap(request.targets, least);
      if (!(here < least)) continue;
      least = here;
      request.from.swap(request.targets);
    }
  }

  TorsionMoves moves_;
  SmallSterics sterics_;
  std::uint64_t seed_;
};

}  // namespace

std::unique_ptr<Sampler> make_torsions_sampler(const SamplerSetting& setting) {
  return std::make_unique<TorsionsSampler>(setting);
}

}  // namespace pliant
