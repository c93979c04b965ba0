// SPDX-License-Identifier: MIT
#include "pliant/rigidity/unit_set.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace pliant {
namespace {

constexpr std::size_t most_bars_a_joint = 256;
/// Among so many bars from a joint to a unit, three that are not on one line are looked for.
constexpr std::size_t most_links = 6;
/// Least squared sine, roughly, of a triangle that counts as one.
constexpr double flat = 1e-6;

/// 16 times the squared area over the fourth power of the longest side (Heron); below 0 if the
/// sides cannot meet.
bool is_flat(double a2, double b2, double c2) {
  const double longest = std::max({a2, b2, c2});
  const double sum = a2 + b2 + c2;
  const double area = sum * sum - 2.0 * (a2 * a2 + b2 * b2 + c2 * c2);
  return !(area > flat * longest * longest);
}

class UnitSearch {
 public:
  explicit UnitSearch(const Framework& framework)
      : framework_(framework),
        units_of_(framework.joint_count()),
        mark_(framework.joint_count(), none),
        links_(framework.joint_count(), {0, 0}),
        taken_(framework.joint_count(), 0) {
    index_low_to_high();
  }

  UnitSet run() {
    // Triangles on a line turn about it, so they take nothing in: they come after the others.
    for (const bool flat_ones : {false, true})
      for (std::size_t a = 0; a < framework_.joint_count(); ++a)
        look_for_triangles(static_cast<Joint>(a), flat_ones);
    add_rods();
    return std::move(found_);
  }

 private:
  static constexpr auto none = static_cast<BarIndex>(-1);

  bool is_hub(Joint joint) const { return framework_.neighbours(joint).size() > most_bars_a_joint; }

  /// Bars from each joint to those with more bars, so that each triangle is met once and soon
  /// (Chiba, Nishizeki, SIAM J. Comput. 14 (1985) 210).
  void index_low_to_high() {
    const auto rank = [&](Joint j) { return std::pair(framework_.neighbours(j).size(), j); };
    std::vector<Incidence> up;
    for (std::size_t i = 0; i < framework_.joint_count(); ++i) {
      const auto joint = static_cast<Joint>(i);
      up.clear();
      if (!is_hub(joint))
        for (const Incidence& at : framework_.neighbours(joint))
          if (!is_hub(at.joint) && rank(joint) < rank(at.joint)) up.push_back(at);
      up_.add(up);
    }
  }

  void look_for_triangles(Joint a, bool flat_ones) {
    for (const Incidence& at : up_.at(a)) mark_[at.joint] = at.bar;
    for (const Incidence& ab : up_.at(a))
      for (const Incidence& bc : up_.at(ab.joint))
        if (mark_[bc.joint] != none) take_triangle(a, ab, bc, flat_ones);
    for (const Incidence& at : up_.at(a)) mark_[at.joint] = none;
  }

  void take_triangle(Joint a, const Incidence& ab, const Incidence& bc, bool flat_ones) {
    const auto square = [&](BarIndex bar) {
      const double rest = framework_.rest_lengths()[bar];
      return rest * rest;
    };
    if (is_flat(square(ab.bar), square(bc.bar), square(mark_[bc.joint])) != flat_ones) return;
    const std::array<Joint, 3> corners{a, ab.joint, bc.joint};
    if (is_covered(corners)) return;
    members_.assign(corners.begin(), corners.end());
    if (!flat_ones) grow();
    std::sort(members_.begin(), members_.end());
    for (Joint joint : members_)
      units_of_[joint].push_back(static_cast<std::uint32_t>(found_.size()));
    found_.add(members_);
  }

  bool is_covered(std::span<const Joint> joints) const {
    const auto holds = [&](std::uint32_t unit) {
      return std::all_of(joints.begin() + 1, joints.end(), [&](Joint joint) {
        return std::binary_search(units_of_[joint].begin(), units_of_[joint].end(), unit);
      });
    };
    return std::any_of(units_of_[joints[0]].begin(), units_of_[joints[0]].end(), holds);
  }

  /// Takes joints into members_ until none is left that has three bars to them.
  void grow() {
    ++unit_;
    for (Joint joint : members_) taken_[joint] = unit_;
    for (std::size_t k = 0; k < members_.size(); ++k)
      for (const Incidence& at : framework_.neighbours(members_[k])) count_link(at.joint);
  }

  void count_link(Joint joint) {
    if (taken_[joint] == unit_ || is_hub(joint)) return;
    auto& [unit, count] = links_[joint];
    if (unit != unit_) {
      unit = unit_;
      count = 0;
    }
    if (++count < 3 || !is_held(joint)) return;
    taken_[joint] = unit_;
    members_.push_back(joint);
  }

  /// Has `joint` bars to three members that are not on one line?
  bool is_held(Joint joint) const {
    std::array<Joint, most_links> ends{};
    std::size_t count = 0;
    for (const Incidence& at : framework_.neighbours(joint))
      if (taken_[at.joint] == unit_ && count < most_links) ends[count++] = at.joint;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k)
          if (spans_a_plane(ends[i], ends[j], ends[k])) return true;
    return false;
  }

  bool spans_a_plane(Joint a, Joint b, Joint c) const {
    const auto ab = squared_distance(a, b), bc = squared_distance(b, c),
               ac = squared_distance(a, c);
    return ab && bc && ac && !is_flat(*ab, *bc, *ac);
  }

  /// The squared distance as drawn, else as a bar between them says.
  std::optional<double> squared_distance(Joint a, Joint b) const {
    const auto drawn = framework_.drawn();
    if (!drawn.empty()) return norm_squared(drawn[b] - drawn[a]);
    for (const Incidence& at : framework_.neighbours(a))
      if (at.joint == b) {
        const double rest = framework_.rest_lengths()[at.bar];
        return rest * rest;
      }
    return std::nullopt;
  }

  void add_rods() {
    const UnitsOfJoints units(found_, framework_.joint_count());
    std::vector<std::uint32_t> both;
    for (Bar bar : framework_.bars()) {
      units.common(bar.a, bar.b, both);
      if (!both.empty()) continue;
      const std::array<Joint, 2> ends{std::min(bar.a, bar.b), std::max(bar.a, bar.b)};
      found_.add(ends);
    }
  }

  const Framework& framework_;
  Grouped<Incidence> up_;  ///< bars from each joint to those with more
  std::vector<std::vector<std::uint32_t>> units_of_;
  std::vector<BarIndex> mark_;                                  ///< bar to the joint in hand
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links_;  ///< unit, bars to it
  std::vector<std::uint32_t> taken_;                            ///< the last unit that took it
  std::uint32_t unit_ = 0;
  std::vector<Joint> members_;
  UnitSet found_;
};

}  // namespace

UnitsOfJoints::UnitsOfJoints(const UnitSet& set, std::size_t joint_count)
    : units_(joint_count, [&](const auto& put) {
        for (std::size_t unit = 0; unit < set.size(); ++unit)
          for (Joint joint : set.at(unit)) put(joint, static_cast<std::uint32_t>(unit));
      }) {}

void UnitsOfJoints::common(Joint a, Joint b, std::vector<std::uint32_t>& out) const {
  out.clear();
  const auto fewer = at(a).size() <= at(b).size() ? at(a) : at(b);
  const auto more = at(a).size() <= at(b).size() ? at(b) : at(a);
  for (std::uint32_t unit : fewer)
    if (std::binary_search(more.begin(), more.end(), unit)) out.push_back(unit);
}

UnitSet find_units(const Framework& framework) { return UnitSearch(framework).run(); }

}  // namespace pliant
