// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/near/near_rules.hpp"

#include <algorithm>
#include <utility>

namespace pliant {

NearRules::NearRules(const Framework& framework, const BodyPlan& plan, double skin)
    : plan_(plan),
      rules_(framework),
      sterics_(*framework.sterics()),
      excluded_near_(plan.place_count()),
      kind_(plan.place_count(), 0),
      kinds_(sterics_.kind_count) {
  for (Slot place = 0; place < plan.place_count(); ++place)
    if (plan.place_of(plan.joint_at()[place]) == place) listed_.push_back(place);
  for (Slot place : listed_) kind_[place] = sterics_.kinds[plan.joint_at()[place]];
  exclude();
  exclude_within_bodies();
  set_reaches(skin);
}

void NearRules::set_excluded(Slot low, Slot high, bool is_excluded) {
  excluded_near_[low].set(low, high, is_excluded);
  excluded_near_[high].set(high, low, is_excluded);
}

void NearRules::exclude_within_bodies() {
  for (const PlanBody& body : plan_.bodies())
    for (Slot low = body.first; low < body.last; ++low)
      for (Slot high = low; high < body.last && high - low <= NeighbourMask::reach; ++high)
        set_excluded(low, high, true);
}

/// Pairs that are few bonds apart: a bit each where their places are near, else as pairs with
/// distances of their own. Of two that are given for a pair, the first counts.
void NearRules::exclude() {
  std::vector<std::pair<Slot, Special>> found;
  const auto pair_of = [&](Joint a, Joint b) {
    const Slot one = plan_.place_of(a), other = plan_.place_of(b);
    return std::pair(std::min(one, other), std::max(one, other));
  };
  for (const OwnDistance& own : sterics_.own) {
    const auto [low, high] = pair_of(own.a, own.b);
    found.push_back({low, {high, own.least}});
  }
  for (Slot place : listed_) {
    const Joint joint = plan_.joint_at()[place];
    for (Joint other : rules_.excluded_above(joint)) {
      const auto [low, high] = pair_of(joint, other);
      if (high - low <= NeighbourMask::reach) {
        set_excluded(low, high, true);
      } else {
        found.push_back({low, {high, 0.0}});
      }
    }
  }
  for (const OwnDistance& own : sterics_.own) {
    const auto [low, high] = pair_of(own.a, own.b);
    if (high - low <= NeighbourMask::reach) set_excluded(low, high, false);
  }
  special_ = Grouped<Special>(plan_.place_count(), [&](const auto& put) {
    for (const auto& [low, special] : found) put(low, special);
  });
}

/// How far the list reaches for each two kinds; as far as for any where a pair's own distance is
/// above that of its kinds.
void NearRules::set_reaches(double skin) {
  const bool is_beyond = std::any_of(sterics_.own.begin(), sterics_.own.end(), [&](auto& own) {
    return own.least > sterics_.of_kinds(own.a, own.b);
  });
  for (double least : sterics_.least) {
    const double reach = (is_beyond ? rules_.largest() : least) + skin + list_slack;
    square_reaches_.push_back(least > 0.0 || is_beyond ? static_cast<float>(reach * reach) : 0.0F);
  }
  for (std::size_t kind = 0; kind < kinds_; ++kind) {
    const float* reaches = square_reaches_.data() + kind * kinds_;
    widest_.push_back(*std::max_element(reaches, reaches + kinds_));
  }
}

double NearRules::least(Slot i, Slot j) const {
  const auto body_at = plan_.body_at();
  if (body_at[i] == body_at[j]) return 0.0;
  for (const Special& special : special_.at(i))
    if (special.other == j) return special.least;
  const auto& units = sterics_.units;
  const Joint a = plan_.joint_at()[i], b = plan_.joint_at()[j];
  if (!units.empty() && units[a] == units[b] && units[a] != no_unit) return 0.0;
  return sterics_.least[kind_[i] * kinds_ + kind_[j]];
}

}  // namespace pliant
