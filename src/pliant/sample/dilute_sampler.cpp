// SPDX-License-Identifier: MIT
// Sampler `dilute`.
#include <cmath>

#include "pliant/base/math/elementary.hpp"
#include "pliant/base/random.hpp"
#include "pliant/sample/modes_sampler.hpp"
#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant {
namespace {

/// Frames of `modes` with contacts off by chance, the weaker the more often.
class DiluteSampler final : public ModesSampler {
 public:
  explicit DiluteSampler(const SamplerSetting& setting)
      : ModesSampler(setting),
        limits_(setting.framework.limits()),
        seed_(setting.options.seed),
        contact_energy_(setting.options.contact_energy * kj_per_kcal) {}

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           FrameRequest& request) const override {
    ModesSampler::ask(frame, step, attempt, now, request);
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

}  // namespace

std::unique_ptr<Sampler> make_dilute_sampler(const SamplerSetting& setting) {
  return std::make_unique<DiluteSampler>(setting);
}

}  // namespace pliant
