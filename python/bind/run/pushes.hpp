// SPDX-License-Identifier: MIT
// Pushes (forces on joints) in Python: tuples (joint, (x, y, z)).
#pragma once

#include <nanobind/stl/tuple.h>

#include <tuple>

#include "bind.hpp"
#include "checks.hpp"
#include "pliant/base/error.hpp"
#include "pliant/perturb/perturbation.hpp"

namespace pliant::python {

using PythonForce = std::tuple<double, double, double>;
using PythonPushes = std::vector<std::tuple<std::int64_t, PythonForce>>;

inline PythonPushes pushes_to_python(const std::vector<JointForce>& pushes) {
  PythonPushes tuples;
  for (const JointForce& push : pushes)
    tuples.emplace_back(push.joint, PythonForce{push.force.x, push.force.y, push.force.z});
  return tuples;
}

inline std::vector<JointForce> pushes_from(const PythonPushes& tuples) {
  std::vector<JointForce> pushes;
  for (const auto& [joint, force] : tuples) {
    if (joint < 0 || joint > std::numeric_limits<Joint>::max())
      fail_index("joint", joint, std::numeric_limits<Joint>::max());
    const auto [x, y, z] = force;
    pushes.push_back({static_cast<Joint>(joint), {x, y, z}});
  }
  return pushes;
}

/// Throws IndexError or InputError unless each push is a finite force on a joint of `framework`.
inline void check_pushes(const Framework& framework, const std::vector<JointForce>& pushes) {
  for (const JointForce& push : pushes) {
    joint_at(framework, push.joint);
    if (!is_finite(push.force))
      throw InputError("replay: force on " + framework.label(push.joint) + " is not finite");
  }
}

}  // namespace pliant::python
