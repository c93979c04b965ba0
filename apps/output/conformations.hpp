// SPDX-License-Identifier: MIT
// What moves in conformers, for reports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/sample_report.hpp"

namespace pliant::app {

/// By name.
struct Conformations {
  std::vector<std::string> rotors, rings, rigid_rings, amines, amides, atropisomers;
  std::size_t loop_bodies = 0;
  bool are_loops_drawn = true;
};

/// Nothing for a sampler that goes along modes.
std::optional<Conformations> conformations_of(const Job& job, const SampledSystem& system);

}  // namespace pliant::app
