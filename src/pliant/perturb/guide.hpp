// SPDX-License-Identifier: MIT
// Guides (steered motion): where joints are asked to go. What pushers `rock`, `pull` and
// `pair_distance` follow.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// The distance of the centres of two groups of joints, as an experiment (FRET, DEER, a cross-link)
/// has it.
struct PairDistance {
  std::vector<Joint> first, second;  ///< one joint or more each; all count alike in a centre
  double least = 0.0, most = 0.0;    ///< Angstrom; alike where a single distance is asked for

  friend bool operator==(const PairDistance&, const PairDistance&) = default;
};

/// Where the centre of a group of joints is pulled to.
struct Pull {
  std::vector<Joint> joints;  ///< one or more; all count alike
  Vec3 to;                    ///< Angstrom

  friend bool operator==(const Pull&, const Pull&) = default;
};

struct Guide {
  std::vector<Vec3> rock;  ///< (N) Angstrom: how far out joints swing to either side; or none
  std::vector<Pull> pulls;
  std::vector<PairDistance> pairs;
  std::int64_t period = 100;  ///< steps of rocking there, back and to the other side

  bool empty() const { return rock.empty() && pulls.empty() && pairs.empty(); }

  friend bool operator==(const Guide&, const Guide&) = default;
};

/// Within so many Angstrom of where it should be a centre, or a distance, has arrived.
inline constexpr double guide_slack = 0.05;

/// Throws OptionError where lengths, joints, distances or the period make no sense.
void check(const Guide& guide, const Framework& framework);

/// Names of the pushers that follow what the guide has, in the order in which they act.
std::vector<std::string> pushers_of(const Guide& guide);

/// Whether nothing is left to follow: all groups are where they are pulled to, and all pair
/// distances are reached. Never while it rocks.
bool has_arrived(const Guide& guide, std::span<const Vec3> positions);

/// From the centre of the group to where it is pulled.
Vec3 way_of(const Pull& pull, std::span<const Vec3> positions);

/// From the centre of the first group to that of the second.
Vec3 line_of(const PairDistance& pair, std::span<const Vec3> positions);

/// How far it is outside its interval: above 0 if too far apart, below 0 if too near.
double excess_of(const PairDistance& pair, std::span<const Vec3> positions);

}  // namespace pliant
