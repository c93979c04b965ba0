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

/// What all pushers of a step did together. The technique begins at the root joint, which the first
/// pusher that moved anything sets.
struct Push {
  std::int64_t root_joint = no_joint;  ///< the pushed joint; the first one if all were pushed
  Vec3 force;                          ///< force on the root joint, kJ/(mol Angstrom); 0 if none
  bool all = false;                    ///< any joint may have been moved
  std::vector<Joint> joints = {};  ///< if not `all`: the moved joints, the root joint among them
  std::vector<JointForce> forces = {};  ///< in the order in which move_by_verlet applied them
  std::vector<JointForce> asked = {};   ///< forces of hands before they were held back

  void clear();
  /// Notes that a joint was moved, and by which force.
  void add(Joint joint, Vec3 by = {});
  /// Notes that any joint may have been moved. `first_joint` is no_joint if there is none.
  void add_all(std::int64_t first_joint, Vec3 by = {});
  /// What a resolve has to look at. Valid as long as this object.
  Disturbed disturbed() const;
};

}  // namespace pliant
