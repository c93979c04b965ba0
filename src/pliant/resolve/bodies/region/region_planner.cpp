// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/region/region_planner.hpp"

#include <algorithm>

namespace pliant {
namespace {

constexpr std::uint32_t no_place = ~std::uint32_t{0};
constexpr std::size_t most_of_tail = 6;
/// Larger units stay where they are unless they are pushed themselves.
constexpr std::size_t most_joints_of_unit = 64;

}  // namespace

RegionPlanner::RegionPlanner(const Framework& framework)
    : set_(units_of_bodies(framework)),
      graph_(connect_units(framework, set_)),
      units_of_(set_, framework.joint_count()),
      is_in_(set_.size(), 0),
      body_of_(set_.size(), no_place) {
  plan_.place_of_.assign(framework.joint_count(), no_place);
}

const BodyPlan& RegionPlanner::plan(std::span<const Joint> joints, std::size_t most_bodies) {
  clear();
  most_bodies_ = most_bodies;
  choose(joints);
  place_ground();
  for (std::uint32_t unit : region_) hang_on_ground(unit);
  if (!plan_.bodies_.empty()) end_tree(0);
  for (std::uint32_t unit : region_) add_tree_of_own(unit);
  return plan_;
}

void RegionPlanner::clear() {
  for (std::uint32_t unit : region_) {
    is_in_[unit] = 0;
    body_of_[unit] = no_place;
  }
  for (Joint joint : plan_.joint_at_) plan_.place_of_[joint] = no_place;
  region_.clear();
  bodies_ = 0;
  units_.clear();
  first_unit_.clear();
  plan_.bodies_.clear();
  plan_.trees_.clear();
  plan_.tree_of_.clear();
  plan_.turn_count_ = 0;
  plan_.joint_at_.clear();
  plan_.body_at_.clear();
  plan_.cuts_.clear();
  plan_.ground_ = no_place;
}

/// Calls visit(other unit) for all units that share a connection with one.
template <class Visit>
void RegionPlanner::visit_around(std::uint32_t unit, const Visit& visit) const {
  for (const Link& connection : graph_.links.at(unit))
    for (const Link& other : graph_.links.at(connection.node))
      if (other.node != unit) visit(other.node);
}

void RegionPlanner::choose(std::span<const Joint> joints) {
  for (Joint joint : joints)
    for (std::uint32_t unit : units_of_.at(joint)) take(unit, true);
  for (std::size_t k = 0; k < region_.size(); ++k) take_around(region_[k]);
  take_tails();
}

void RegionPlanner::take(std::uint32_t unit, bool is_seed) {
  if (is_in_[unit] != 0) return;
  is_in_[unit] = is_seed ? 2 : 1;
  region_.push_back(unit);
  if (is_seed || !is_end(unit)) ++bodies_;
}

void RegionPlanner::take_around(std::uint32_t unit) {
  visit_around(unit, [&](std::uint32_t other) {
    if (set_.at(other).size() > most_joints_of_unit) return;
    if (is_end(other) || bodies_ < most_bodies_) take(other, false);
  });
}

void RegionPlanner::take_tails() {
  for (std::size_t k = 0; k < region_.size(); ++k)
    visit_around(region_[k], [&](std::uint32_t other) {
      if (is_in_[other] == 0 && find_tail(other))
        for (std::uint32_t unit : tail_) take(unit, false);
    });
}

/// Finds the units beyond the region that begin with `unit`; false if they are many.
bool RegionPlanner::find_tail(std::uint32_t unit) {
  tail_.assign(1, unit);
  std::size_t bodies = 0;
  for (std::size_t k = 0; k < tail_.size(); ++k) {
    if (set_.at(tail_[k]).size() > most_joints_of_unit) return false;
    if (!is_end(tail_[k]) && ++bodies > most_of_tail) return false;
    visit_around(tail_[k], [&](std::uint32_t other) {
      if (is_in_[other] == 0 && std::find(tail_.begin(), tail_.end(), other) == tail_.end())
        tail_.push_back(other);
    });
  }
  return true;
}

bool RegionPlanner::has_unit_outside(Joint joint) const {
  const auto units = units_of_.at(joint);
  return std::any_of(units.begin(), units.end(),
                     [&](std::uint32_t unit) { return is_in_[unit] == 0; });
}

/// The first body: all joints that units of the region share with others.
void RegionPlanner::place_ground() {
  for (std::uint32_t unit : region_)
    for (Joint joint : set_.at(unit)) {
      if (plan_.place_of_[joint] != no_place || !has_unit_outside(joint)) continue;
      plan_.add_place(joint, 0);
    }
  if (plan_.joint_at_.empty()) return;
  plan_.ground_ = 0;
  PlanBody ground;
  ground.last = static_cast<Slot>(plan_.joint_at_.size());
  plan_.bodies_.push_back(ground);
  first_unit_.push_back(UnitPlaces::none);
}

/// Begins a part of the region at a unit with a connection to a unit outside.
void RegionPlanner::hang_on_ground(std::uint32_t unit) {
  if (body_of_[unit] != no_place) return;
  for (const Link& connection : graph_.links.at(unit))
    for (const Link& other : graph_.links.at(connection.node))
      if (is_in_[other.node] == 0) return add_tree(unit, connection.node);
}

void RegionPlanner::add_tree_of_own(std::uint32_t unit) {
  if (body_of_[unit] != no_place) return;
  const auto first = static_cast<std::uint32_t>(plan_.bodies_.size());
  add_tree(unit, no_place);
  end_tree(first);
}

void RegionPlanner::end_tree(std::uint32_t first) {
  const auto last = static_cast<std::uint32_t>(plan_.bodies_.size());
  plan_.tree_of_.resize(last, static_cast<std::uint32_t>(plan_.trees_.size()));
  plan_.trees_.push_back({first, last});
}

/// Depth first over the units of the region.
void RegionPlanner::add_tree(std::uint32_t root, UnitNode from) {
  waiting_.assign(1, {root, from, 0});
  while (!waiting_.empty()) {
    const Waiting next = waiting_.back();
    waiting_.pop_back();
    if (body_of_[next.unit] != no_place) continue;
    add_body(next.unit, next.from, next.parent);
    for (const Link& connection : graph_.links.at(next.unit))
      for (const Link& other : graph_.links.at(connection.node))
        if (is_in_[other.node] != 0 && body_of_[other.node] == no_place)
          waiting_.push_back({other.node, connection.node, body_of_[next.unit]});
  }
}

void RegionPlanner::add_body(std::uint32_t unit, UnitNode from, std::uint32_t parent) {
  PlanBody body;
  UnitPlaces places;
  body.first_turn = static_cast<std::uint32_t>(plan_.turn_count_);
  if (from != no_place) {
    const UnitConnection entry = graph_.connection(from);
    body.parent = static_cast<std::int32_t>(parent);
    places.parent = first_unit_[parent];
    body.a = places.a = plan_.place_in(parent, entry.a);
    body.b = places.b = plan_.place_in(parent, entry.b);
  }
  body.first = body.last = static_cast<Slot>(plan_.joint_at_.size());
  plan_.turn_count_ += body.turns();
  body_of_[unit] = static_cast<std::uint32_t>(plan_.bodies_.size());
  plan_.bodies_.push_back(body);
  first_unit_.push_back(static_cast<std::uint32_t>(units_.size()));
  add_unit(unit, places);
  add_riders(unit);
}

/// The joints of a unit, to the last body.
void RegionPlanner::add_unit(std::uint32_t unit, UnitPlaces places) {
  const auto is_at = [&](Joint joint, Slot place) {
    return place != UnitPlaces::none && plan_.joint_at_[place] == joint;
  };
  places.first = static_cast<Slot>(plan_.joint_at_.size());
  for (Joint joint : set_.at(unit)) {
    if (is_at(joint, places.a) || is_at(joint, places.b)) continue;
    plan_.add_place(joint, static_cast<std::uint32_t>(plan_.bodies_.size() - 1));
  }
  places.last = plan_.bodies_.back().last = static_cast<Slot>(plan_.joint_at_.size());
  units_.push_back(places);
}

bool RegionPlanner::may_ride(std::uint32_t unit) const {
  return is_in_[unit] == 1 && is_end(unit) && body_of_[unit] == no_place;
}

void RegionPlanner::add_riders(std::uint32_t unit) {
  const std::uint32_t body = body_of_[unit];
  for (const Link& connection : graph_.links.at(unit))
    for (const Link& other : graph_.links.at(connection.node)) {
      if (other.node == unit || !may_ride(other.node)) continue;
      body_of_[other.node] = body;
      const UnitConnection entry = graph_.connection(connection.node);
      add_unit(other.node, {0, 0, plan_.place_in(body, entry.a), plan_.place_in(body, entry.b),
                            first_unit_[body]});
    }
}

}  // namespace pliant
