// SPDX-License-Identifier: MIT
// Perturbations (pushes, random forces): what breaks the bars at the start of a step.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// How hard to push. Checked once, by check().
struct PerturbOptions {
  double force = 50.0;        ///< magnitude of a random force, kJ/(mol Angstrom)
  double timestep = 0.01;     ///< ps
  double damping = 0.0;       ///< share of its velocity that a pushed joint loses a step, 0 to 1
  double displacement = 0.1;  ///< length of a random displacement (Angstrom)
};

/// Throws OptionError naming the option, its value and its range.
void check(const PerturbOptions& options);

/// What a perturbation did: where the technique begins, and the force there.
struct Push {
  std::int64_t root_joint = no_joint;  ///< the pushed joint; the first one if all were pushed
  Vec3 force;                          ///< kJ/(mol Angstrom); 0 if none
  bool one_joint = false;              ///< no joint but the root joint was moved
};

/// A force on one joint during one step.
struct JointForce {
  Joint joint = 0;
  Vec3 force;  ///< kJ/(mol Angstrom)
};

/// What a perturbation may use.
struct PerturbRequest {
  const Framework& framework;
  const PerturbOptions& options;
  RandomKey key = {};  ///< seed, walker and step; each draw adds its domain and joint
  /// The joints that the last step moved, if known: no other has state.previous to be brought up.
  std::optional<std::span<const Joint>> moved_before = {};
};

/// One row of the table of perturbations.
struct PerturbationEntry {
  std::string_view name;
  std::string_view summary;
  /// Moves state.positions, with state.previous left as the positions before the push.
  Push (*push)(const PerturbRequest& request, State& state);
};

std::span<const PerturbationEntry> perturbations();

/// The row of that name. Throws OptionError listing the known names.
const PerturbationEntry& find_perturbation(std::string_view name);

/// The forces that the perturbation `force` meets in `count` steps after step key.step: each of
/// size options.force, in a random direction, on a random joint that is free to move (ForceGen).
/// Throws OptionError if every joint is pinned, or as check() does.
std::vector<JointForce> random_pushes(const Framework& framework, const PerturbOptions& options,
                                      RandomKey key, std::int64_t count);

/// Moves joints by position Verlet under forces, and notes where all joints were:
///   x_new = x + (1 - damping) (x - x_old) + a dt^2,   a [Angstrom/ps^2] = 100 F / m
/// (Verlet, Phys. Rev. 159 (1967) 98; thesis appendix A). Other joints stay. Pinned joints stay.
/// In a planar framework the z of forces and motions counts for nothing. The factor 100 turns
/// kJ/(mol Angstrom u) into Angstrom/ps^2.
Push apply_forces(const PerturbRequest& request, std::span<const JointForce> forces, State& state);

}  // namespace pliant
