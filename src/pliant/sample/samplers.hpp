// SPDX-License-Identifier: MIT
// The table of samplers.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "pliant/sample/sampler.hpp"

namespace pliant {

struct ConformerMoves;

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

/// What conformers of these options may change.
ConformerMoves conformer_moves(const SampleOptions& options);

/// The row of that name. Throws OptionError listing the known names.
const SamplerEntry& find_sampler(std::string_view name);

}  // namespace pliant
