// SPDX-License-Identifier: MIT
#include "pliant/rigidity/framework_rigidity.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/graphs/disjoint_sets.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/rigidity/joint_pebbles.hpp"

namespace pliant {
namespace {

/// Independent motions of points as one body: of one point, of a line, of more.
std::size_t motions_of_body(std::uint32_t dimension, std::size_t span) {
  if (span == 0) return dimension;
  if (dimension == 2) return 3;
  return span == 1 ? 5 : 6;
}

/// Whether points coincide (0), are on one line (1), or not (2).
std::size_t span_of(const std::vector<Vec3>& points) {
  const auto farthest = [&](const auto& distance_to) {
    double most = 0.0;
    Vec3 at = points.front();
    for (const Vec3 point : points)
      if (const double distance = distance_to(point); distance > most) {
        most = distance;
        at = point;
      }
    return std::pair(most, at);
  };
  const Vec3 origin = points.front();
  const auto [length, end] = farthest([&](Vec3 x) { return norm(x - origin); });
  if (!(length > 0.0)) return 0;
  const Vec3 along = (1.0 / length) * (end - origin);
  const auto beside = farthest([&](Vec3 x) { return norm(cross(x - origin, along)); }).first;
  return beside > rank_tolerance * length ? 2 : 1;
}

std::vector<Joint> pinned_of(const Framework& framework) {
  std::vector<Joint> pinned;
  for (Joint joint = 0; joint < framework.joint_count(); ++joint)
    if (framework.is_pinned(joint)) pinned.push_back(joint);
  return pinned;
}

std::size_t coordinates(const Framework& framework, std::uint32_t dimension) {
  return dimension * (framework.joint_count() - framework.pinned_count());
}

/// Motions of the whole that leave pinned joints where they are.
std::size_t motions_of_whole(const Framework& framework, std::span<const Vec3> positions,
                             std::uint32_t dimension) {
  std::vector<Vec3> all, pinned;
  for (Joint joint = 0; joint < framework.joint_count(); ++joint) {
    Vec3 at = positions[joint];
    if (dimension == 2) at.z = 0.0;
    all.push_back(at);
    if (framework.is_pinned(joint)) pinned.push_back(at);
  }
  if (all.empty()) return 0;
  const std::size_t of_all = motions_of_body(dimension, span_of(all));
  return pinned.empty() ? of_all : of_all - motions_of_body(dimension, span_of(pinned));
}

/// The same at almost all positions.
std::size_t usual_motions_of_whole(const Framework& framework, std::uint32_t dimension) {
  const auto motions = [&](std::size_t joints) {
    return joints == 0 ? 0 : motions_of_body(dimension, joints - 1);
  };
  return motions(framework.joint_count()) - motions(framework.pinned_count());
}

/// Pinned joints are one body: each is held by bars to the first ones.
std::size_t counted_rank(const Framework& framework, std::uint32_t dimension) {
  JointPebbles game(framework.joint_count(), dimension);
  const std::vector<Joint> pinned = pinned_of(framework);
  for (std::size_t k = 0; k < pinned.size(); ++k)
    for (std::size_t first = 0; first < std::min<std::size_t>(k, dimension); ++first)
      game.add(pinned[first], pinned[k]);
  std::size_t rank = 0;
  for (const Bar bar : framework.bars())
    if (!framework.is_pinned(bar.a) || !framework.is_pinned(bar.b)) rank += game.add(bar.a, bar.b);
  return rank;
}

std::vector<OverconstrainedPart> overconstrained_parts(const Framework& framework,
                                                       const BarRank& rank) {
  DisjointSets bars;
  bars.reset(framework.bar_count());
  std::vector<BarIndex> first(framework.joint_count(), ~BarIndex{0});
  for (BarIndex k = 0; k < framework.bar_count(); ++k) {
    if (!rank.redundant[k]) continue;
    for (const Joint joint : {framework.bars()[k].a, framework.bars()[k].b}) {
      if (framework.is_pinned(joint)) continue;
      if (first[joint] == ~BarIndex{0}) first[joint] = k;
      bars.unite(first[joint], k);
    }
  }
  std::vector<std::vector<BarIndex>> of_first(framework.bar_count());
  for (BarIndex k = 0; k < framework.bar_count(); ++k)
    if (rank.redundant[k]) of_first[bars.find(k)].push_back(k);
  std::vector<OverconstrainedPart> parts;
  for (auto& members : of_first) {
    if (members.empty()) continue;
    OverconstrainedPart part{std::move(members), 0, 0};
    std::vector<Joint> joints;
    double stresses = 0.0;
    for (const BarIndex k : part.bars) {
      joints.insert(joints.end(), {framework.bars()[k].a, framework.bars()[k].b});
      stresses += rank.stresses[k];
    }
    std::sort(joints.begin(), joints.end());
    part.joints = std::size_t(std::unique(joints.begin(), joints.end()) - joints.begin());
    part.self_stresses = std::size_t(std::lround(stresses));
    parts.push_back(std::move(part));
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.bars.size() > b.bars.size(); });
  return parts;
}

void check(const Framework& framework, std::span<const Vec3> positions) {
  if (positions.size() != framework.joint_count())
    throw InputError("positions: expected " + std::to_string(framework.joint_count()) +
                     ", one for each joint, found " + std::to_string(positions.size()));
  for (Joint joint = 0; joint < positions.size(); ++joint)
    if (!std::isfinite(norm(positions[joint])))
      throw InputError("positions: that of " + framework.label(joint) + " is not finite");
}

}  // namespace

FrameworkRigidity framework_rigidity(const Framework& framework, std::span<const Vec3> positions) {
  check(framework, positions);
  FrameworkRigidity found;
  const std::uint32_t dimension = found.dimension = framework.is_planar() ? 2 : 3;
  found.parts = find_components(framework).count;
  found.rank = bar_rank(framework, positions, dimension);
  found.generic_rank = generic_bar_rank(framework, dimension);
  found.counted_rank = counted_rank(framework, dimension);
  const std::size_t free = coordinates(framework, dimension);
  const std::size_t usual = usual_motions_of_whole(framework, dimension);
  found.motions = {free - found.rank.rank, motions_of_whole(framework, positions, dimension)};
  found.generic_motions = {free - found.generic_rank.rank, usual};
  found.counted_motions = {free - found.counted_rank, usual};
  found.overconstrained = overconstrained_parts(framework, found.rank);
  return found;
}

}  // namespace pliant
