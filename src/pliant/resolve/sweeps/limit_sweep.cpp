// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/limit_sweep.hpp"

#include <cmath>

#include "pliant/resolve/method/project_bar.hpp"
#include "pliant/resolve/method/shares.hpp"

namespace pliant {
namespace {

// What a sweep aims at: bars need the rest of the room.
constexpr double share_of_tolerance = 0.5;

bool overlaps(std::span<const Vec3> positions, const NeighbourPair& pair, double most) {
  return pair.least - distance(positions[pair.a], positions[pair.b]) > most;
}

/// As escape_direction(), for joints that no bar joins.
Vec3 escape_of_pair(RandomKey key, Joint a, Joint b, bool planar) {
  key.domain = Domain::escape;
  key.joint = (std::uint64_t{a} + 1) << 32 | b;
  RandomSequence draws(key);
  return planar ? draws.direction_in_plane() : draws.direction();
}

}  // namespace

LimitSweep::LimitSweep(const Framework& framework, bool mass_weighted, const Tolerance& tolerance,
                       double skin)
    : framework_(framework), mass_weighted_(mass_weighted), tolerance_(tolerance) {
  if (framework.sterics() != nullptr) contacts_.emplace(framework, skin);
}

void LimitSweep::begin(LimitsOff off) {
  limits_.clear();
  for (LimitIndex k = 0; k < framework_.limits().size(); ++k) {
    if (is_off(off, k)) continue;
    const Limit& limit = framework_.limits()[k];
    const auto [share_a, share_b] = equal_shares(framework_, limit.a, limit.b, mass_weighted_);
    limits_.push_back({limit, share_a, share_b, k});
  }
}

std::int64_t LimitSweep::sweep(std::span<Vec3> positions, const RandomKey& key) {
  for (const PlannedLimit& planned : limits_) project(positions, planned, key);
  auto looked_at = static_cast<std::int64_t>(limits_.size());
  if (!contacts_ || !contacts_->update(positions)) return looked_at;
  part_overlaps(positions, key);
  return looked_at + static_cast<std::int64_t>(overlaps_.size());
}

void LimitSweep::project(std::span<Vec3> positions, const PlannedLimit& planned,
                         const RandomKey& key) const {
  const Limit& limit = planned.limit;
  Vec3 &a = positions[limit.a], &b = positions[limit.b];
  const double length = distance(a, b);
  const double outside = excess(limit, length);
  const double room = share_of_tolerance * tolerance_.limit;
  if (!(std::abs(outside) > room)) return;
  project_bar(a, b, outside > 0.0 ? limit.most + room : limit.least - room, planned.share_a,
              planned.share_b,
              [&] { return escape_of_pair(key, limit.a, limit.b, framework_.is_planar()); });
}

/// Pairs that one of these moves together wait for the next sweep.
void LimitSweep::part_overlaps(std::span<Vec3> positions, const RandomKey& key) {
  const double room = share_of_tolerance * tolerance_.overlap;
  overlaps_.clear();
  for (const NeighbourPair& pair : contacts_->near())
    if (overlaps(positions, pair, room)) overlaps_.push_back(pair);
  for (const NeighbourPair& pair : overlaps_) {
    if (!overlaps(positions, pair, room)) continue;
    const auto [share_a, share_b] = equal_shares(framework_, pair.a, pair.b, mass_weighted_);
    project_bar(positions[pair.a], positions[pair.b], pair.least - room, share_a, share_b,
                [&] { return escape_of_pair(key, pair.a, pair.b, framework_.is_planar()); });
  }
}

Look LimitSweep::look(std::span<const Vec3> positions) {
  const Look limits = look_at_limits(positions);
  if (limits != Look::all_whole || !contacts_) return limits;
  return look_at_contacts(positions);
}

Look LimitSweep::look_at_limits(std::span<const Vec3> positions) const {
  for (const PlannedLimit& planned : limits_) {
    const Limit& limit = planned.limit;
    const double length = distance(positions[limit.a], positions[limit.b]);
    if (!std::isfinite(length)) return Look::not_finite;
    if (!(std::abs(excess(limit, length)) <= tolerance_.limit)) return Look::broken;
  }
  return Look::all_whole;
}

Look LimitSweep::look_at_contacts(std::span<const Vec3> positions) {
  if (!contacts_->update(positions)) return Look::not_finite;
  for (const NeighbourPair& pair : contacts_->near())
    if (overlaps(positions, pair, tolerance_.overlap)) return Look::broken;
  return Look::all_whole;
}

std::unique_ptr<LimitSweep> make_limit_sweep(const Framework& framework, bool mass_weighted,
                                             const Tolerance& tolerance) {
  if (framework.has_bars_only()) return nullptr;
  return std::make_unique<LimitSweep>(framework, mass_weighted, tolerance);
}

}  // namespace pliant
