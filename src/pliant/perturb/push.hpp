// SPDX-License-Identifier: MIT
// Push: what was moved, and by which force, at the start of a step.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/framework/disturbed.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// A force on one joint during one step.
struct JointForce {
  Joint joint = 0;
  Vec3 force;  ///< kJ/(mol Angstrom)
};

/// What the pushers of a step did, all together. Where the technique begins is said by the first of
/// them that moved anything.
struct Push {
  std::int64_t root_joint = no_joint;  ///< the pushed joint; the first one if all were pushed
  Vec3 force;                          ///< on it, kJ/(mol Angstrom); 0 if none
  bool all = false;                    ///< any joint may have been moved
  std::vector<Joint> joints = {};      ///< unless `all`: those that were, the root joint among them
  std::vector<JointForce> forces = {};  ///< in the order in which move_by_verlet applied them
  std::vector<JointForce> asked = {};   ///< by hands: those of `forces` before they were held back

  void clear();
  /// Notes a joint that was moved, and the force that did.
  void add(Joint joint, Vec3 by = {});
  /// Notes that any joint may have been moved; no_joint: there is none.
  void add_all(std::int64_t first_joint, Vec3 by = {});
  /// As a resolve is told; valid as long as this is.
  Disturbed disturbed() const;
};

}  // namespace pliant
