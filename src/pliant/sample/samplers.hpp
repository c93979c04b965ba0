// SPDX-License-Identifier: MIT
// Samplers: they choose a target for each frame, and the contacts that are off in it. Targets are
// then resolved with exact geometry.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/framework/course.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/sample/network/elastic_network.hpp"

namespace pliant {

class BodyPlan;
struct SampleOptions;

/// The target of one frame.
struct FrameRequest {
  std::vector<Vec3> targets;  ///< (N) Angstrom
  std::vector<Vec3> from;     ///< (N) whole start of the resolve; empty: where the frame begins
  /// (L) 1: the limit is switched off in this frame; empty: all are on
  std::vector<std::uint8_t> limits_off;
  Course course;  ///< the way to the targets; without a function: straight lines
  DrawnBy drawn_by = DrawnBy::other;
};

/// Makes requests for frames. Several threads may call it at once.
class Sampler {
 public:
  virtual ~Sampler() = default;
  /// Whether a frame begins at the one before, not at the start.
  virtual bool is_walk() const { return false; }
  /// Number of steps from the beginning of a frame to its end, each requested and resolved.
  virtual int steps_a_frame() const { return 1; }
  /// Fills `request` for step `step` of a frame. `attempt` is the number of failed attempts at it.
  /// `now` (N) is where the step begins, `before` where the step before it began. Depends only on
  /// the arguments and the seed.
  virtual void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
                   std::span<const Vec3> before, FrameRequest& request) const = 0;
};

/// What samplers are made from; all must outlive them.
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
  bool has_amplitude = true;  ///< whether the amplitude determines how far frames go
};

std::span<const SamplerEntry> samplers();

/// The default sampler of a molecule: `torsions` for a single molecule without residues of chains
/// (`has_residues`), with at most 2000 atoms and 64 rotors; otherwise `modes`, since torsions do
/// not move molecules against each other.
std::string_view usual_sampler(const Framework& framework, std::span<const Vec3> start,
                               bool has_residues);

/// The row of that name. Throws OptionError listing the known names.
const SamplerEntry& find_sampler(std::string_view name);

}  // namespace pliant
