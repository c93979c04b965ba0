// SPDX-License-Identifier: MIT
#include "steps/visits.hpp"

#include <span>

namespace pliant::play {
namespace {

/// What a person sees of a step bar by bar: enough for an hour of slow motion.
constexpr std::size_t most_events = 100000;

}  // namespace

/// A sweep visits each bar once: the next one has begun when a bar comes again.
void Visits::note(const RepairedBar& visit) {
  if (seen_[visit.bar]) {
    ++sweep_;
    seen_.assign(seen_.size(), false);
  }
  seen_[visit.bar] = true;
  if (events_.size() / 4 >= most_events) {
    is_whole_ = false;
    return;
  }
  for (std::uint32_t number : {visit.bar, visit.near, visit.far})
    events_.push_back(static_cast<std::int32_t>(number));
  events_.push_back(sweep_);
  for (Joint joint : {visit.near, visit.far}) {
    const Vec3 x = visit.positions[joint];
    for (double part : {x.x, x.y, x.z}) moved_.push_back(part);
  }
}

void Visits::add_to(Reply& reply) const {
  reply.fields["whole"] = is_whole_;
  reply.add("events", std::span<const std::int32_t>(events_));
  reply.add("moved", std::span<const double>(moved_));
}

}  // namespace pliant::play
