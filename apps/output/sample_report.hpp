// SPDX-License-Identifier: MIT
// What pliant sample prints at its end.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "options/sample_settings.hpp"

namespace pliant::app {

/// What was sampled; must not outlive the framework.
struct SampledSystem {
  std::string_view kind;  ///< of the model
  const Framework& framework;
  std::span<const Vec3> start;  ///< (N) Angstrom
  std::size_t contacts = 0;
  std::vector<std::string> told = {}, missing = {};  ///< by preparation
};

/// As a table, as JSON or not at all.
void print_sample(const SampleSettings& settings, const SampledSystem& system,
                  const SampleSummary& summary, const std::vector<std::string>& warnings);

/// What the command ends with.
int exit_code_of(const SampleSummary& summary);

}  // namespace pliant::app
