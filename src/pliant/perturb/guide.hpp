// SPDX-License-Identifier: MIT
// Guides (steered motion): targets that the pushers `rock`, `pull` and `pair_distance` follow.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// A target for the distance between the centres of two groups of joints, as measured by an
/// experiment (FRET, DEER, a cross-link).
struct PairDistance {
  std::vector<Joint> first, second;  ///< one joint or more each, with equal weights
  double least = 0.0, most = 0.0;    ///< Angstrom; equal for a single distance

  friend bool operator==(const PairDistance&, const PairDistance&) = default;
};

/// A target for the centre of a group of joints.
struct Pull {
  std::vector<Joint> joints;  ///< one or more, with equal weights
  Vec3 to;                    ///< Angstrom

  friend bool operator==(const Pull&, const Pull&) = default;
};

struct Guide {
  std::vector<Vec3> rock;  ///< (N) largest displacement to either side (Angstrom); or empty
  std::vector<Pull> pulls;
  std::vector<PairDistance> pairs;
  std::int64_t period = 100;  ///< steps of one oscillation

  bool empty() const { return rock.empty() && pulls.empty() && pairs.empty(); }

  friend bool operator==(const Guide&, const Guide&) = default;
};

/// A centre or a distance has arrived within this distance of its target (Angstrom).
inline constexpr double guide_slack = 0.05;

/// Throws OptionError where lengths, joints, distances or the period make no sense.
void check(const Guide& guide, const Framework& framework);

/// Names of the pushers that the guide needs, in the order in which they act.
std::vector<std::string> pushers_of(const Guide& guide);

/// Whether all groups and all pair distances have reached their targets. Never while the guide
/// rocks.
bool has_arrived(const Guide& guide, std::span<const Vec3> positions);

/// The vector from the centre of the group to its target.
Vec3 way_of(const Pull& pull, std::span<const Vec3> positions);

/// The vector from the centre of the first group to that of the second.
Vec3 line_of(const PairDistance& pair, std::span<const Vec3> positions);

/// How far the distance is outside its interval (Angstrom): positive if too large, negative if too
/// small.
double excess_of(const PairDistance& pair, std::span<const Vec3> positions);

}  // namespace pliant
