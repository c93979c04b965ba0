// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/region/local_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "pliant/resolve/bodies/pull/contact_steps.hpp"

namespace pliant {
namespace {

constexpr LimitIndex no_limit = ~LimitIndex{0};

}  // namespace

void LocalContacts::begin(std::span<const Vec3> still, Vec3 origin, LimitsOff off,
                          JointNeighbours* neighbours) {
  still_ = still;
  origin_ = origin;
  off_ = off;
  neighbours_ = neighbours;
}

ContactViolation LocalContacts::find(std::span<const Vec3> x, double weight) {
  found_.clear();
  worst_ = {};
  const auto joint_at = plan_.joint_at();
  if (neighbours_ != nullptr)
    for (Slot place = 0; place < joint_at.size(); ++place)
      if (moves(place) && plan_.place_of(joint_at[place]) == place)
        neighbours_->look(joint_at[place], x[place] + origin_);
  for (Slot place = 0; place < joint_at.size(); ++place)
    if (moves(place) && plan_.place_of(joint_at[place]) == place) find_at(place, x, weight);
  std::sort(found_.begin(), found_.end(), [](const Found& one, const Found& other) {
    return std::tie(one.a, one.b, one.limit) < std::tie(other.a, other.b, other.limit);
  });
  rows_.clear();
  for (const Found& found : found_) rows_.push_back(found.row);
  return worst_;
}

void LocalContacts::find_at(Slot place, std::span<const Vec3> x, double weight) {
  if (!framework_.limits().empty()) find_limits(place, x, weight);
  if (neighbours_ != nullptr) find_overlaps(place, x, weight);
}

/// Where the other joint of a pair is. False if both move as one, or if the other one finds the
/// pair.
bool LocalContacts::find_other(Slot place, Joint joint, std::span<const Vec3> x,
                               Other& other) const {
  other.place = plan_.place_of(joint);
  if (other.place == DistanceRow::still || !moves(other.place)) {
    other = {DistanceRow::still, still_[joint] - origin_};
    return true;
  }
  other.at = x[other.place];
  return plan_.joint_at()[place] < joint && plan_.body_at()[place] != plan_.body_at()[other.place];
}

void LocalContacts::find_limits(Slot place, std::span<const Vec3> x, double weight) {
  const Joint joint = plan_.joint_at()[place];
  Other other{};
  for (LimitIndex k : framework_.limits_at(joint)) {
    const Limit& limit = framework_.limits()[k];
    const Joint far = limit.a == joint ? limit.b : limit.a;
    if (is_off(off_, k) || !find_other(place, far, x, other)) continue;
    const froda::Aim aim = froda::aim_of(limit);
    const Vec3 apart = x[place] - other.at;
    const double square = norm_squared(apart);
    if (square <= aim.most * aim.most && square >= aim.least * aim.least) continue;
    const double length = std::sqrt(square);
    worst_.limit = std::max(worst_.limit, std::abs(excess(limit, length)));
    const double gap = (length > aim.most ? aim.most : aim.least) - length;
    found_.push_back(
        {joint,
         far,
         k,
         {place, other.place, (1.0 / (length + froda::least_length)) * apart, gap, weight}});
  }
}

void LocalContacts::find_overlaps(Slot place, std::span<const Vec3> x, double weight) {
  const Joint joint = plan_.joint_at()[place];
  Other other{};
  for (const NearJoint& near : neighbours_->near(joint)) {
    if (!find_other(place, near.joint, x, other)) continue;
    const double aim = near.least + froda::margin;
    const Vec3 apart = x[place] - other.at;
    const double square = norm_squared(apart);
    if (square >= aim * aim) continue;
    const double length = std::sqrt(square);
    worst_.overlap = std::max(worst_.overlap, near.least - length);
    found_.push_back({joint,
                      near.joint,
                      no_limit,
                      {place, other.place, (1.0 / (length + froda::least_length)) * apart,
                       aim - length, weight}});
  }
}

}  // namespace pliant
