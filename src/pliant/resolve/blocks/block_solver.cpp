// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/block_solver.hpp"

#include <algorithm>

namespace pliant {
namespace {

constexpr std::int64_t most_iterations = 1000;
/// Newton's method arrives soon or not at all from a shape nearer to one that is whole.
constexpr std::int64_t most_iterations_on_the_way = 20;

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
  return parts_[block] && iterate(block, entry, key, positions, summary, most_iterations);
}

bool BlockSolver::go_part_of_the_way(std::uint32_t block, Joint entry, const RandomKey& key,
                                     const WayOfPush& way, std::span<Vec3> positions,
                                     ResolveSummary& summary) {
  if (!parts_[block]) return false;
  const Vec3 shift = positions[entry] - way.from[entry];
  for (double share : {0.5, 0.25, 0.0}) {
    each_joint(block, [&](Joint joint) {
      const Vec3 carried = way.from[joint] + shift;
      if (joint != entry) positions[joint] = carried + share * (way.to[joint] - carried);
    });
    if (iterate(block, entry, key, positions, summary, most_iterations_on_the_way)) return true;
  }
  return false;
}

bool BlockSolver::iterate(std::uint32_t block, Joint entry, const RandomKey& key,
                          std::span<Vec3> positions, ResolveSummary& summary, std::int64_t most) {
  const BarEquations::Part part = *parts_[block];
  equations_.hold(part, entry);
  equations_.gather(part, positions);
  const PartResult result = newton_.make_whole(part, key, [&] { return most-- > 0; });
  equations_.scatter(part, positions);
  summary.dropped_bars += result.dropped_bars;
  summary.projections += (result.iterations + 1) * std::int64_t(part.bars.size());
  return result.whole;
}

}  // namespace pliant
