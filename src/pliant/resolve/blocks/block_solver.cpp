// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/block_solver.hpp"

#include <algorithm>

namespace pliant {
namespace {

constexpr std::int64_t most_iterations = 1000;

std::vector<double> weights_of(const Framework& framework, const Technique& technique) {
  const auto masses = framework.inverse_masses();
  std::vector<double> weights(masses.begin(), masses.end());
  if (!technique.mass_weighted)
    for (double& weight : weights) weight = weight > 0.0 ? 1.0 : 0.0;
  return weights;
}

}  // namespace

BlockSolver::BlockSolver(const Framework& framework, const Technique& technique,
                         const Tolerance& tolerance, std::span<const std::vector<BarIndex>> blocks)
    : equations_(framework, weights_of(framework, technique), tolerance), newton_(equations_) {
  for (const auto& bars : blocks) {
    parts_.push_back(equations_.append(bars));
    if (!parts_.back()) holds_all_ = false;
  }
}

bool BlockSolver::any_overbraced() const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [](const auto& part) { return part && BarNewton::is_overbraced(*part); });
}

bool BlockSolver::solve(std::uint32_t block, Joint entry, const RandomKey& key,
                        std::span<Vec3> positions, ResolveSummary& summary) {
  if (!parts_[block]) return false;
  const BarEquations::Part part = *parts_[block];
  equations_.hold(part, entry);
  equations_.gather(part, positions);
  std::int64_t left = most_iterations;
  const PartResult result = newton_.make_whole(part, key, [&] { return left-- > 0; });
  equations_.scatter(part, positions);
  summary.dropped_bars += result.dropped_bars;
  summary.projections += (result.iterations + 1) * std::int64_t(part.bars.size());
  return result.whole;
}

}  // namespace pliant
