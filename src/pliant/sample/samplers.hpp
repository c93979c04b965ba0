// SPDX-License-Identifier: MIT
// Ways to move (samplers): where each frame is asked to go, and which contacts it is free of. A
// table of them; what is asked for is then resolved with exact geometry.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/sample/network/elastic_network.hpp"

namespace pliant {

class BodyPlan;
struct SampleOptions;

/// What one frame is asked for.
struct FrameRequest {
  std::vector<Vec3> targets;             ///< (N) Angstrom
  std::vector<Vec3> from;                ///< (N) with all bars whole; empty: where it begins
  std::vector<std::uint8_t> limits_off;  ///< (L) 1: off in this frame; empty: none is
};

/// Asks for frames. Of several threads each may ask at once.
class Sampler {
 public:
  virtual ~Sampler() = default;
  /// Whether a frame begins at the one before, and not at the start.
  virtual bool is_walk() const { return false; }
  /// Steps from where a frame begins to where it ends, each asked for and resolved.
  virtual int steps_a_frame() const { return 1; }
  /// Fills `request` for step `step` of a frame. `attempt` counts how often this was not resolved.
  /// `now` (N) is where the step begins, `before` where the step before it did. A function of the
  /// arguments and the seed alone.
  virtual void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
                   std::span<const Vec3> before, FrameRequest& request) const = 0;
};

/// What samplers are made with; all outlive them.
struct SamplerSetting {
  const Framework& framework;
  const BodyPlan& plan;
  std::span<const Vec3> start;  ///< (N) Angstrom
  const NetworkNodes& nodes;    ///< coarsened
  const SampleOptions& options;
};

/// One row of the table of samplers.
struct SamplerEntry {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<Sampler> (*make)(const SamplerSetting& setting);
  bool has_amplitude = true;  ///< whether the amplitude tells how far frames go
};

std::span<const SamplerEntry> samplers();

/// What suits a molecule: `torsions` for a single one of no residues of chains (`has_residues`), of
/// at most 2000 atoms and 64 rotors; else `modes`. Several molecules move against each other by
/// `modes`, which torsions do not.
std::string_view usual_sampler(const Framework& framework, std::span<const Vec3> start,
                               bool has_residues);

/// The row of that name. Throws OptionError listing the known names.
const SamplerEntry& find_sampler(std::string_view name);

}  // namespace pliant
