// SPDX-License-Identifier: MIT
#include "pliant/path/detour.hpp"

#include <algorithm>

#include "pliant/base/math/elementary.hpp"
#include "pliant/base/random.hpp"

namespace pliant {
namespace {

constexpr int detour_steps = 6;
constexpr double furthest_aside = 2.0;  // Angstrom a step, of the residue furthest from its goal
constexpr double smooth = 4.0;          // residues along which a detour changes its direction

/// (3 R) uniform in [-1, 1).
std::vector<double> noise(std::size_t count, std::uint64_t attempt, std::uint64_t seed) {
  std::vector<double> values;
  values.reserve(count + 4);
  for (std::uint64_t block = 1; values.size() < count; ++block)
    for (std::uint64_t bits : philox4x64({block, 0, 0, 0}, {seed, attempt}))
      values.push_back(double(bits >> 11) * 0x1p-52 - 1.0);
  return values;
}

/// Weights by the number of residues between two, until they vanish.
std::vector<double> smoothing_weights(std::size_t residues) {
  std::vector<double> weights;
  for (std::size_t apart = 0; apart < residues; ++apart) {
    const double along = double(apart) / smooth;
    weights.push_back(exact_bits_exp(-0.5 * along * along));
    if (weights.back() == 0.0) break;
  }
  return weights;
}

/// (R) where residues that are far from their goal are sent in each step.
std::vector<Vec3> aside(const PathWalker& walker, std::span<const Vec3> goal, std::uint64_t attempt,
                        std::uint64_t seed) {
  const PathSide& side = walker.side();
  const std::vector<Vec3> left = ways(walker.asked(), goal);
  std::vector<double> furthest(*std::max_element(side.leader.begin(), side.leader.end()) + 1);
  for (std::size_t k = 0; k < left.size(); ++k) {
    double& of_residue = furthest[side.leader[side.asked[k]]];
    of_residue = std::max(of_residue, norm(left[k]));
  }
  const double most = std::max(*std::max_element(furthest.begin(), furthest.end()), 1e-9);
  std::vector<Vec3> field = smooth_field(furthest.size(), attempt, seed);
  for (std::size_t k = 0; k < field.size(); ++k) field[k] *= furthest_aside * (furthest[k] / most);
  return field;
}

}  // namespace

std::vector<Vec3> smooth_field(std::size_t residues, std::uint64_t attempt, std::uint64_t seed) {
  const std::vector<double> random = noise(3 * residues, attempt, seed);
  const std::vector<double> weights = smoothing_weights(residues);
  std::vector<Vec3> field(residues);
  double longest = 0.0;
  for (std::size_t k = 0; k < residues; ++k) {
    const std::size_t end = std::min(residues, k + weights.size());
    for (std::size_t j = k < weights.size() ? 0 : k - weights.size() + 1; j < end; ++j)
      field[k] += weights[j < k ? k - j : j - k] *
                  Vec3{random[3 * j], random[3 * j + 1], random[3 * j + 2]};
    longest = std::max(longest, norm(field[k]));
  }
  for (Vec3& direction : field) direction *= 1.0 / longest;
  return field;
}

Detour::Detour(PathWalker& walker, const Way& stuck, std::span<const Vec3> goal,
               std::uint64_t attempt, std::uint64_t seed)
    : walker_(walker), goal_(goal.begin(), goal.end()) {
  const std::size_t back = path_patience << (attempt % 4), last = stuck.places.size() - 1;
  way_ = stuck.first((last > back ? last - back : 0) + 1);
  walker_.put(stuck.places.back());
  aside_ = aside(walker_, goal, attempt, seed);
  walker_.put(way_.places.back());
}

bool Detour::advance() {
  if (steps_ == detour_steps) return false;
  const StepEnd end = walker_.step(walker_.asked(), 0.0, aside_);
  if (end == StepEnd::stopped) return true;
  ++steps_;
  if (end == StepEnd::whole) {
    way_.add(walker_.now(), walker_.apart(goal_));
  } else {
    for (Vec3& direction : aside_) direction *= 0.5;
  }
  return true;
}

}  // namespace pliant
