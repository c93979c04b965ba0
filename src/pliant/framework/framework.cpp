// SPDX-License-Identifier: MIT
#include "pliant/framework/framework.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

// Beyond these a squared length under- or overflows a double.
constexpr double shortest_rest_length = 1e-150;
constexpr double longest_rest_length = 1e150;
constexpr double furthest_limit = longest_rest_length;
// Beyond these a mass or the sum of two inverse masses under- or overflows a double.
constexpr double least_mass = 1e-150;
constexpr double largest_mass = 1e150;
// Drawn positions are where lengths were measured: they may differ by rounding.
constexpr double most_drawn_error = 1e-9;

}  // namespace

Framework::Framework(FrameworkParts parts)
    : joint_count_(parts.joint_count),
      bars_(std::move(parts.bars)),
      rest_lengths_(std::move(parts.rest_lengths)),
      atoms_(std::move(parts.atoms)),
      drawn_(std::move(parts.drawn)),
      limits_(std::move(parts.limits)),
      sterics_(std::move(parts.sterics)),
      torsion_preferences_(std::move(parts.torsion_preferences)),
      planar_(parts.planar) {
  check_counts();
  take_masses(parts.masses, parts.pinned);
  check_bars();
  check_drawn();
  link_joints();
  merge_duplicate_bars();
  check_limits();
  index_limits();
}

void Framework::check_counts() const {
  if (joint_count_ >= std::numeric_limits<Joint>::max())
    throw InputError("framework: " + std::to_string(joint_count_) +
                     " joints, but fewer than 2^32 - 1 can be held");
  // Each bar has two incidences, and they are counted in 32 bits.
  if (bars_.size() > std::numeric_limits<BarIndex>::max() / 2)
    throw InputError("framework: " + std::to_string(bars_.size()) +
                     " bars, but fewer than 2^31 can be held");
  if (rest_lengths_.size() != bars_.size())
    throw InputError("framework: " + std::to_string(bars_.size()) + " bars but " +
                     std::to_string(rest_lengths_.size()) + " rest lengths");
  if (!atoms_) return;
  if (atoms_->size() != joint_count_)
    throw InputError("framework: " + std::to_string(joint_count_) + " joints but " +
                     std::to_string(atoms_->size()) + " atom names");
  check(*atoms_);
}

void Framework::take_masses(const std::vector<double>& masses, const std::vector<Joint>& pinned) {
  if (!masses.empty() && masses.size() != joint_count_)
    throw InputError("framework: " + std::to_string(joint_count_) + " joints but " +
                     std::to_string(masses.size()) + " masses");
  inverse_masses_.assign(joint_count_, 1.0);
  for (std::size_t i = 0; i < masses.size(); ++i) {
    if (!(masses[i] >= least_mass && masses[i] <= largest_mass))
      throw InputError("mass of " + label(static_cast<Joint>(i)) + " is " + number_text(masses[i]) +
                       ": must be from 1e-150 to 1e150 u");
    inverse_masses_[i] = 1.0 / masses[i];
  }
  pin(pinned);
}

void Framework::pin(std::span<const Joint> joints) {
  for (Joint joint : joints) {
    if (joint >= joint_count_)
      throw InputError("pinned joint " + std::to_string(joint) + " of " +
                       std::to_string(joint_count_) + " does not exist");
    if (inverse_masses_[joint] != 0.0) ++pinned_count_;
    inverse_masses_[joint] = 0.0;
  }
}

Framework Framework::with_pinned(std::span<const Joint> joints) const {
  Framework copy = *this;
  copy.pin(joints);
  return copy;
}

void Framework::check_bars() const {
  for (std::size_t k = 0; k < bars_.size(); ++k) {
    const Bar bar = bars_[k];
    if (bar.a >= joint_count_ || bar.b >= joint_count_)
      throw InputError("bar " + std::to_string(k) + " joins joints " + std::to_string(bar.a) +
                       " and " + std::to_string(bar.b) + " but there are " +
                       std::to_string(joint_count_) + " joints");
    if (bar.a == bar.b)
      throw InputError("bar " + std::to_string(k) + " joins " + label(bar.a) + " to itself");
    const double length = rest_lengths_[k];
    if (!(length >= shortest_rest_length && length <= longest_rest_length))
      throw InputError("bar " + label(bar) + " has rest length " + number_text(length) +
                       ": must be from 1e-150 to 1e150 Angstrom");
  }
}

void Framework::check_drawn() const {
  if (drawn_.empty()) return;
  if (drawn_.size() != joint_count_)
    throw InputError("framework: " + std::to_string(joint_count_) + " joints but " +
                     std::to_string(drawn_.size()) + " drawn positions");
  for (std::size_t k = 0; k < bars_.size(); ++k) {
    const double length = distance(drawn_[bars_[k].a], drawn_[bars_[k].b]);
    if (!(std::abs(length - rest_lengths_[k]) <= most_drawn_error * rest_lengths_[k]))
      throw InputError("bar " + label(bars_[k]) + " is drawn " + number_text(length) +
                       " long: its rest length is " + number_text(rest_lengths_[k]) + " Angstrom");
  }
}

/// Duplicates are found in linear time: while the bars of a joint are looked at, `first_bar` tells
/// which bar reached each other end first.
void Framework::merge_duplicate_bars() {
  constexpr auto none = std::numeric_limits<BarIndex>::max();
  std::vector<BarIndex> first_bar(joint_count_, none);
  std::vector<bool> drop(bars_.size(), false);
  for (std::size_t i = 0; i < joint_count_; ++i) {
    for (const Incidence& at : neighbours(static_cast<Joint>(i))) {
      BarIndex& first = first_bar[at.joint];
      if (first == none) {
        first = at.bar;
      } else if (rest_lengths_[first] != rest_lengths_[at.bar]) {
        throw InputError("bar " + label(bars_[first]) + " is given twice, with rest lengths " +
                         number_text(rest_lengths_[first]) + " and " +
                         number_text(rest_lengths_[at.bar]) + " Angstrom");
      } else {
        drop[at.bar] = true;
      }
    }
    for (const Incidence& at : neighbours(static_cast<Joint>(i))) first_bar[at.joint] = none;
  }
  merged_bar_count_ = static_cast<std::size_t>(std::count(drop.begin(), drop.end(), true));
  if (merged_bar_count_ == 0) return;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < bars_.size(); ++k) {
    if (drop[k]) continue;
    bars_[kept] = bars_[k];
    rest_lengths_[kept++] = rest_lengths_[k];
  }
  bars_.resize(kept);
  rest_lengths_.resize(kept);
  link_joints();
}

void Framework::check_limits() const {
  if (limits_.size() > std::numeric_limits<LimitIndex>::max() / 2)
    throw InputError("framework: " + std::to_string(limits_.size()) +
                     " limits, but fewer than 2^31 can be held");
  for (std::size_t k = 0; k < limits_.size(); ++k) check_limit(k);
  if (sterics_) check(*sterics_, joint_count_);
  if (torsion_preferences_) check(*torsion_preferences_, joint_count_);
}

void Framework::check_limit(std::size_t index) const {
  const Limit& limit = limits_[index];
  if (limit.a >= joint_count_ || limit.b >= joint_count_)
    throw InputError("limit " + std::to_string(index) + " joins joints " + std::to_string(limit.a) +
                     " and " + std::to_string(limit.b) + " but there are " +
                     std::to_string(joint_count_) + " joints");
  if (limit.a == limit.b)
    throw InputError("limit " + std::to_string(index) + " joins " + label(limit.a) + " to itself");
  const std::string pair = "limit " + label(Bar{limit.a, limit.b});
  if (!(limit.least >= 0.0 && limit.least <= furthest_limit))
    throw InputError(pair + " has least distance " + number_text(limit.least) +
                     ": must be from 0 to 1e150 Angstrom");
  if (!(limit.most > 0.0 && (limit.most <= furthest_limit || std::isinf(limit.most))))
    throw InputError(pair + " has most distance " + number_text(limit.most) +
                     ": must be above 0, up to 1e150 Angstrom or infinite");
  if (limit.least > limit.most)
    throw InputError(pair + " has least distance " + number_text(limit.least) + " above most " +
                     number_text(limit.most) + " Angstrom");
  if (!std::isfinite(limit.energy))
    throw InputError(pair + " has energy " + number_text(limit.energy) + ": must be finite");
  for (const Incidence& at : neighbours(limit.a))
    if (at.joint == limit.b)
      throw InputError(pair + " has a bar already, of " + number_text(rest_lengths_[at.bar]) +
                       " Angstrom");
}

void Framework::index_limits() {
  if (limits_.empty()) return;
  first_limit_.assign(joint_count_ + 1, 0);
  for (const Limit& limit : limits_) {
    ++first_limit_[limit.a + 1];
    ++first_limit_[limit.b + 1];
  }
  for (std::size_t i = 0; i < joint_count_; ++i) first_limit_[i + 1] += first_limit_[i];
  limits_at_.resize(2 * limits_.size());
  std::vector<std::uint32_t> next(first_limit_.begin(), first_limit_.end() - 1);
  for (LimitIndex k = 0; k < limits_.size(); ++k) {
    limits_at_[next[limits_[k].a]++] = k;
    limits_at_[next[limits_[k].b]++] = k;
  }
}

std::span<const LimitIndex> Framework::limits_at(Joint joint) const {
  if (limits_.empty()) return {};
  return {limits_at_.data() + first_limit_[joint], limits_at_.data() + first_limit_[joint + 1]};
}

FrameworkParts Framework::parts() const {
  FrameworkParts parts{.joint_count = joint_count_,
                       .bars = bars_,
                       .rest_lengths = rest_lengths_,
                       .atoms = atoms_,
                       .drawn = drawn_,
                       .planar = planar_,
                       .limits = limits_,
                       .sterics = sterics_,
                       .torsion_preferences = torsion_preferences_};
  for (Joint joint = 0; joint < joint_count_; ++joint) {
    if (is_pinned(joint)) parts.pinned.push_back(joint);
    parts.masses.push_back(is_pinned(joint) ? 1.0 : 1.0 / inverse_masses_[joint]);
  }
  return parts;
}

std::string Framework::label(Joint joint) const {
  return atoms_ ? atoms_->label(joint) : "joint " + std::to_string(joint);
}

std::string Framework::label(Bar bar) const {
  if (atoms_) return atoms_->label(bar.a) + " - " + atoms_->label(bar.b);
  return std::to_string(bar.a) + " - " + std::to_string(bar.b);
}

}  // namespace pliant
