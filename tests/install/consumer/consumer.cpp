// SPDX-License-Identifier: MIT
// Stretches the one bar of two joints and resolves it: the analytic answer is known.
#include <cmath>
#include <cstdio>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/resolve/resolve.hpp"

int main() {
  pliant::FrameworkParts parts;
  parts.joint_count = 2;
  parts.bars = {{0, 1}};
  parts.rest_lengths = {1.5};
  const pliant::Framework framework(std::move(parts));
  std::vector<pliant::Vec3> positions = {{0, 0, 0}, {0, 0, 2}};
  const auto summary = resolve(framework, pliant::Technique{}, positions);
  const double length = distance(positions[0], positions[1]);
  std::printf("%s\n", summary.brief(framework).c_str());
  return summary.converged() && std::abs(length - 1.5) <= 1.5e-6 ? 0 : 1;
}
