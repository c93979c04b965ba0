// SPDX-License-Identifier: MIT
#include "pliant/perturb/push.hpp"

namespace pliant {

void Push::clear() {
  root_joint = no_joint;
  force = {};
  all = false;
  joints.clear();
  forces.clear();
  asked.clear();
}

void Push::add(Joint joint, Vec3 by) {
  joints.push_back(joint);
  if (root_joint != no_joint) return;
  root_joint = joint;
  force = by;
}

void Push::add_all(std::int64_t first_joint, Vec3 by) {
  all = true;
  if (root_joint != no_joint) return;
  root_joint = first_joint;
  force = by;
}

Disturbed Push::disturbed() const {
  return {root_joint == no_joint ? 0 : static_cast<Joint>(root_joint), all, joints};
}

}  // namespace pliant
