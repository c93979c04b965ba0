// SPDX-License-Identifier: MIT
// Prints the result of pliant sample.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "options/sample_settings.hpp"

namespace pliant::app {

/// What was sampled; the framework must outlive it.
struct SampledSystem {
  std::string_view kind;  ///< name of the model
  const Framework& framework;
  std::span<const Vec3> start;  ///< (N) Angstrom
  std::size_t contacts = 0;
  std::vector<std::string> notes = {}, missing = {}, left_out = {};  ///< from preparation
  std::size_t placed = 0;                                            ///< atoms placed by rule
  std::string kinds = {};  ///< of contacts: "54 hydrogen bonds, 4 salt bridges"
};

/// The residues that frames of sampler pocket open or close; none of other samplers.
std::vector<std::string> pocket_of(const SampleSettings& settings, const SampledSystem& system);

/// Prints a table, JSON or nothing.
void print_sample(const SampleSettings& settings, const SampledSystem& system,
                  const SampleSummary& summary, const std::vector<std::string>& warnings);

/// The exit code of the command.
int exit_code_of(const SampleSummary& summary);

}  // namespace pliant::app
