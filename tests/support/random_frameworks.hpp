// SPDX-License-Identifier: MIT
// Random frameworks for RapidCheck, which shrinks what fails to few joints and bars.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "pliant/lab/examples/examples.hpp"

namespace pliant::test {

/// Any graph of 1 to `most_joints` joints on the points of a small lattice (so that coincident,
/// collinear and coplanar joints are common), with any rest lengths from 1/4 to 4 Angstrom, and now
/// and then a pinned joint.
struct AnyFramework {
  Framework framework;
  std::vector<Vec3> positions;
};

inline std::vector<Bar> any_bars(int joints, int most_bars) {
  const auto joint = rc::gen::inRange(0, joints);
  const auto pairs = *rc::gen::resize(
      most_bars, rc::gen::container<std::vector<std::pair<int, int>>>(rc::gen::pair(joint, joint)));
  std::vector<Bar> bars;
  for (const auto& [a, b] : pairs) {
    const Bar bar{static_cast<Joint>(a), static_cast<Joint>(b)}, back{bar.b, bar.a};
    const bool known = std::find(bars.begin(), bars.end(), bar) != bars.end() ||
                       std::find(bars.begin(), bars.end(), back) != bars.end();
    if (a != b && !known) bars.push_back(bar);
  }
  return bars;
}

inline AnyFramework any_framework(int most_joints, int most_bars) {
  FrameworkParts parts;
  const int joints = *rc::gen::inRange(1, most_joints + 1);
  parts.joint_count = static_cast<std::size_t>(joints);
  parts.bars = any_bars(joints, most_bars);
  std::vector<Vec3> positions;
  for (int i = 0; i < joints; ++i) {
    const auto at = *rc::gen::container<std::vector<int>>(3, rc::gen::inRange(-2, 3));
    positions.push_back({double(at[0]), double(at[1]), double(at[2])});
    parts.masses.push_back(*rc::gen::inRange(1, 17));
  }
  for (std::size_t k = 0; k < parts.bars.size(); ++k)
    parts.rest_lengths.push_back(0.25 * *rc::gen::inRange(1, 17));
  if (*rc::gen::inRange(0, 4) == 3)
    parts.pinned.push_back(static_cast<Joint>(*rc::gen::inRange(0, joints)));
  return {Framework(std::move(parts)), std::move(positions)};
}

}  // namespace pliant::test
