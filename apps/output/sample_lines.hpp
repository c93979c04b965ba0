// SPDX-License-Identifier: MIT
// The result of pliant sample in a few lines.
#pragma once

#include <string>

#include "output/sample_report.hpp"

namespace pliant::app {

/// At most seven lines: molecule, what was left out, contacts, frames, how good they are, where
/// they are, and what to do next.
void print_sample_lines(const Job& job, const SampledSystem& system, const SampleSummary& summary);

/// "other torsions drawn in 91 of 100 frames; its contacts held: metal, salt_bridge".
std::string ligand_text(const Job& job, const SampleSummary& summary);

}  // namespace pliant::app
