// SPDX-License-Identifier: MIT
// The table of samplers, and the choice of the default one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/sampler.hpp"

namespace pliant {

struct ConformerMoves;

/// One row of the table of samplers.
struct SamplerEntry {
  std::string_view name;
  std::string_view summary;
  std::unique_ptr<Sampler> (*make)(const SamplerSetting& setting);
  /// Whether an amplitude determines how far frames go. Without one they are conformers: in the
  /// framework of conformer_framework().
  bool has_amplitude = true;
  bool has_place = false;  ///< whether frames open or close what `around` selects
  /// The sampler that draws the first frames, `near_frames`, by which flexibility is computed;
  /// "": all are of one kind.
  std::string_view near_sampler = {};
  std::int64_t frames = usual_frames;  ///< by default
};

std::span<const SamplerEntry> samplers();

/// The row of that name. Throws OptionError listing the known names.
const SamplerEntry& find_sampler(std::string_view name);

/// The sampler of conformers.
const SamplerEntry& conformer_sampler();

/// The default sampler of a molecule: that of conformers for a single molecule without residues of
/// chains, with at most 2000 atoms and 64 rotors, since torsions do not move molecules against each
/// other; `reach` for more than 100 of `residues` (0: it has none); otherwise `modes`. With a place
/// to open or close: `pocket`.
std::string_view usual_sampler(const Framework& framework, std::span<const Vec3> start,
                               std::size_t residues, bool has_place = false);

/// What a user reads about usual_sampler(), and about the default number of frames. Names stand
/// between `quotes`.
std::string usual_sampler_text(std::string_view quotes = "");
std::string usual_frames_text(std::string_view quotes = "");

/// What conformers of these options may change.
ConformerMoves conformer_moves(const SampleOptions& options);

}  // namespace pliant
