// SPDX-License-Identifier: MIT
// What pliant sample prints at its end.
#pragma once

#include <string>
#include <vector>

#include "sample_settings.hpp"

namespace pliant::app {

void print_sample_table(const SampleSettings& settings, const MolecularModel& model,
                        const SampleSummary& summary);
void print_sample_json(const SampleSettings& settings, const MolecularModel& model,
                       const SampleSummary& summary, const std::vector<std::string>& warnings);

}  // namespace pliant::app
