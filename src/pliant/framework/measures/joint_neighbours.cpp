// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/joint_neighbours.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace pliant {
namespace {

/// Lists reach a little further than they must, so that rounding never hides a pair.
constexpr double joint_slack = 1.0 + 1e-9;
constexpr double furthest_listed = 1e9;

bool is_listable(Vec3 x) {
  return std::abs(x.x) <= furthest_listed && std::abs(x.y) <= furthest_listed &&
         std::abs(x.z) <= furthest_listed;
}

std::int64_t hashed_cell_of(double x, double edge) {
  return static_cast<std::int64_t>(std::floor(x / edge));
}

}  // namespace

JointNeighbours::JointNeighbours(const Framework& framework, double skin)
    : rules_(framework),
      skin_(skin),
      edge_((rules_.largest() + skin) * joint_slack),
      first_(std::bit_ceil(framework.joint_count() + 1), none),
      next_(framework.joint_count(), none),
      last_(framework.joint_count(), none),
      listed_at_(framework.joint_count()),
      near_(framework.joint_count()) {}

bool JointNeighbours::start(std::span<const Vec3> positions) {
  if (!std::all_of(positions.begin(), positions.end(), is_listable)) return false;
  std::fill(first_.begin(), first_.end(), none);
  for (auto& list : near_) list.clear();
  for (Joint joint = 0; joint < positions.size(); ++joint) {
    put(joint, positions[joint]);
    list(joint);  // with those that are there already
  }
  return true;
}

void JointNeighbours::look(Joint joint, Vec3 x) {
  if (!(norm_squared(x - listed_at_[joint]) > 0.25 * skin_ * skin_) || !is_listable(x)) return;
  unlist(joint);
  take_out(joint);
  put(joint, x);
  list(joint);
}

/// Cells far apart may share a bucket: those in it are told apart by their distance.
std::size_t JointNeighbours::bucket_at(std::int64_t i, std::int64_t j, std::int64_t k) const {
  std::uint64_t hash = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15U;
  hash ^= static_cast<std::uint64_t>(j) * 0xC2B2AE3D27D4EB4FU;
  hash ^= static_cast<std::uint64_t>(k) * 0x165667B19E3779F9U;
  return (hash ^ (hash >> 32)) & (first_.size() - 1);
}

std::size_t JointNeighbours::bucket_of(Vec3 x) const {
  return bucket_at(hashed_cell_of(x.x, edge_), hashed_cell_of(x.y, edge_),
                   hashed_cell_of(x.z, edge_));
}

void JointNeighbours::put(Joint joint, Vec3 x) {
  listed_at_[joint] = x;
  std::uint32_t& first = first_[bucket_of(x)];
  next_[joint] = first;
  last_[joint] = none;
  if (first != none) last_[first] = joint;
  first = joint;
}

void JointNeighbours::take_out(Joint joint) {
  if (next_[joint] != none) last_[next_[joint]] = last_[joint];
  if (last_[joint] != none) {
    next_[last_[joint]] = next_[joint];
  } else {
    first_[bucket_of(listed_at_[joint])] = next_[joint];
  }
}

/// Visits all joints in the 27 cells around x; each bucket once.
template <class Visit>
void JointNeighbours::visit_around(Vec3 x, const Visit& visit) const {
  const std::array at{hashed_cell_of(x.x, edge_), hashed_cell_of(x.y, edge_),
                      hashed_cell_of(x.z, edge_)};
  std::array<std::size_t, 27> buckets{};
  std::size_t count = 0;
  for (std::int64_t i = -1; i <= 1; ++i)
    for (std::int64_t j = -1; j <= 1; ++j)
      for (std::int64_t k = -1; k <= 1; ++k)
        buckets[count++] = bucket_at(at[0] + i, at[1] + j, at[2] + k);
  std::sort(buckets.begin(), buckets.end());
  const auto last = std::unique(buckets.begin(), buckets.end());
  for (auto bucket = buckets.begin(); bucket != last; ++bucket)
    for (std::uint32_t joint = first_[*bucket]; joint != none; joint = next_[joint]) visit(joint);
}

double JointNeighbours::least_of(Joint a, Joint b) const {
  return a < b ? rules_.of(a, b) : rules_.of(b, a);
}

/// Lists the pairs of a joint, in its own list and in those of the others.
void JointNeighbours::list(Joint joint) {
  const Vec3 x = listed_at_[joint];
  visit_around(x, [&](Joint other) {
    const double square = norm_squared(listed_at_[other] - x);
    if (other == joint || !(square <= edge_ * edge_)) return;
    const double most = rules_.at_most(std::min(joint, other), std::max(joint, other)) + skin_;
    if (!(square <= most * most * joint_slack)) return;
    const double least = least_of(joint, other);
    if (!(least > 0.0) || !(square <= (least + skin_) * (least + skin_) * joint_slack)) return;
    near_[joint].push_back({other, least});
    near_[other].push_back({joint, least});
  });
}

void JointNeighbours::unlist(Joint joint) {
  for (const NearJoint& near : near_[joint]) {
    auto& list = near_[near.joint];
    const auto at = std::find_if(list.begin(), list.end(),
                                 [&](const NearJoint& own) { return own.joint == joint; });
    *at = list.back();
    list.pop_back();
  }
  near_[joint].clear();
}

}  // namespace pliant
