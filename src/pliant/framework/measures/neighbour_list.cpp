// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/neighbour_list.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

#include "pliant/base/error.hpp"
#include "pliant/base/math/cell_list.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

using Ends = std::pair<Joint, Joint>;

// A list reaches a little further than it must, so that rounding never hides a pair.
constexpr double slack = 1.0 + 1e-9;

/// A joint that has gone further than this share of the skin is listed anew as soon as any must be.
constexpr double renewed_share = 0.3;
/// Up to so many are compared with all joints one by one: faster than sorting all into cells.
constexpr std::size_t few = 128;
/// Where more than one joint in so many must be listed anew, all are.
constexpr std::size_t one_in = 2;

std::vector<std::vector<Joint>> neighbours_by_bonds(const Framework& framework) {
  std::vector<std::vector<Joint>> neighbours(framework.joint_count());
  const auto join = [&](Joint a, Joint b) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  };
  const auto& bonds = framework.sterics()->bonds;
  for (const auto& [a, b] : bonds) join(a, b);
  if (bonds.empty())
    for (const Bar bar : framework.bars()) join(bar.a, bar.b);
  return neighbours;
}

/// Sorted by a, then b: counted into place by a, and sorted among the few of one a.
std::vector<NeighbourPair> by_joints(const std::vector<NeighbourPair>& pairs,
                                     std::size_t joint_count) {
  std::vector<std::size_t> end(joint_count + 1, 0);
  for (const NeighbourPair& pair : pairs) ++end[pair.a + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<NeighbourPair> sorted(pairs.size());
  std::size_t first = 0;
  for (const NeighbourPair& pair : pairs) sorted[end[pair.a]++] = pair;
  for (std::size_t joint = 0; joint < joint_count; first = end[joint++])
    std::sort(sorted.begin() + std::ptrdiff_t(first), sorted.begin() + std::ptrdiff_t(end[joint]),
              [](const NeighbourPair& one, const NeighbourPair& other) { return one.b < other.b; });
  return sorted;
}

bool comes_before(const OwnDistance& own, Ends ends) {
  return std::tie(own.a, own.b) < std::tie(ends.first, ends.second);
}

bool comes_first(const NeighbourPair& one, const NeighbourPair& other) {
  return std::tie(one.a, one.b) < std::tie(other.a, other.b);
}

}  // namespace

LeastDistances::LeastDistances(const Framework& framework)
    : sterics_(*framework.sterics()),
      largest_(sterics_.largest()),
      own_(sterics_.own),
      has_own_(framework.joint_count(), 0) {
  for (OwnDistance& own : own_) {
    if (own.a > own.b) std::swap(own.a, own.b);
    has_own_[own.a] = 1;
  }
  std::sort(own_.begin(), own_.end(), [](const OwnDistance& one, const OwnDistance& other) {
    return comes_before(one, {other.a, other.b});
  });
  exclude_within(framework);
}

/// Searches breadth first from each joint, as many bonds deep as are excluded.
void LeastDistances::exclude_within(const Framework& framework) {
  const auto neighbours = neighbours_by_bonds(framework);
  std::vector<std::uint8_t> is_reached(neighbours.size(), 0);
  std::vector<Joint> reached;
  first_.push_back(0);
  for (Joint joint = 0; joint < neighbours.size(); ++joint) {
    reached.assign(1, joint);
    is_reached[joint] = 1;
    std::size_t begin = 0;
    for (int depth = 0; depth < sterics_.excluded_bonds && begin < reached.size(); ++depth) {
      const std::size_t end = reached.size();
      for (; begin < end; ++begin)
        for (Joint next : neighbours[reached[begin]])
          if (is_reached[next] == 0) is_reached[next] = 1, reached.push_back(next);
    }
    for (Joint other : reached) {
      is_reached[other] = 0;
      if (other > joint) excluded_.push_back(other);
    }
    std::sort(excluded_.begin() + std::ptrdiff_t(first_.back()), excluded_.end());
    first_.push_back(excluded_.size());
  }
}

double LeastDistances::of(Joint a, Joint b) const {
  if (has_own_[a] != 0) {
    const auto own = std::lower_bound(own_.begin(), own_.end(), Ends{a, b}, comes_before);
    if (own != own_.end() && own->a == a && own->b == b) return own->least;
  }
  const auto& units = sterics_.units;
  if (!units.empty() && units[a] == units[b] && units[a] != no_unit) return 0.0;
  const auto excluded = excluded_.begin();
  if (std::binary_search(excluded + std::ptrdiff_t(first_[a]),
                         excluded + std::ptrdiff_t(first_[a + 1]), b))
    return 0.0;
  return sterics_.of_kinds(a, b);
}

NeighbourList::NeighbourList(const Framework& framework, double skin)
    : rules_(framework), skin_(skin) {
  if (!(skin > 0.0 && skin <= 1e5))
    throw OptionError("skin = " + number_text(skin) + ": must be above 0, up to 1e5 Angstrom");
}

bool can_be_listed(std::span<const Vec3> positions) {
  constexpr double furthest = 1e300;
  return std::all_of(positions.begin(), positions.end(), [](Vec3 x) {
    return std::abs(x.x) <= furthest && std::abs(x.y) <= furthest && std::abs(x.z) <= furthest;
  });
}

bool NeighbourList::update(std::span<const Vec3> positions) {
  if (!can_be_listed(positions)) return false;
  if (!made_ || listed_at_.size() != positions.size())
    make_list(positions);
  else if (is_out_of_date(positions))
    renew_list(positions);
  return true;
}

bool NeighbourList::is_out_of_date(std::span<const Vec3> positions) const {
  const double most = 0.25 * skin_ * skin_;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!(norm_squared(positions[i] - listed_at_[i]) <= most)) return true;
  return false;
}

void NeighbourList::make_list(std::span<const Vec3> positions) {
  near_.clear();
  listed_at_.assign(positions.begin(), positions.end());
  made_ = true;
  ++lists_made_;
  if (rules_.largest() == 0.0) return;
  CellList(positions, rules_.largest() + slack * skin_)
      .for_each_pair([&](auto a, auto b, double squared) { list(a, b, squared); });
  near_ = by_joints(near_, positions.size());
}

void NeighbourList::list(std::uint32_t a, std::uint32_t b, double squared) {
  const double skin = slack * skin_;
  const auto reaches = [&](double least) {
    return least > 0.0 && squared <= (least + skin) * (least + skin);
  };
  if (!reaches(rules_.at_most(a, b))) return;
  const double least = rules_.of(a, b);
  if (reaches(least)) near_.push_back({a, b, least});
}

void NeighbourList::choose_renewed(std::span<const Vec3> positions) {
  const double least = renewed_share * skin_ * renewed_share * skin_;
  renewed_.clear();
  is_renewed_.assign(positions.size(), 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (norm_squared(positions[i] - listed_at_[i]) <= least) continue;
    is_renewed_[i] = 1;
    renewed_.push_back(static_cast<Joint>(i));
  }
}

/// The pairs of a few joints are found anew, and those of all others are kept: two joints that are
/// not listed were further apart than it takes, each where it was last looked at.
void NeighbourList::renew_list(std::span<const Vec3> positions) {
  if (rules_.largest() == 0.0) return;
  choose_renewed(positions);
  if (renewed_.size() > positions.size() / one_in) return make_list(positions);
  ++lists_made_;
  for (Joint joint : renewed_) listed_at_[joint] = positions[joint];
  std::erase_if(near_, [&](const NeighbourPair& pair) {
    return (is_renewed_[pair.a] | is_renewed_[pair.b]) != 0;
  });
  const auto kept = static_cast<std::ptrdiff_t>(near_.size());
  for_each_pair_of_renewed([&](auto a, auto b, double squared) { list(a, b, squared); });
  std::sort(near_.begin() + kept, near_.end(), comes_first);
  std::inplace_merge(near_.begin(), near_.begin() + kept, near_.end(), comes_first);
}

template <class Visit>
void NeighbourList::for_each_pair_of_renewed(const Visit& visit) const {
  const double cutoff = rules_.largest() + slack * skin_;
  if (renewed_.size() > few) {
    CellList(listed_at_, cutoff).for_each_pair([&](auto a, auto b, double squared) {
      if ((is_renewed_[a] | is_renewed_[b]) != 0) visit(a, b, squared);
    });
    return;
  }
  for (Joint joint : renewed_)
    for (Joint other = 0; other < listed_at_.size(); ++other) {
      const double squared = norm_squared(listed_at_[other] - listed_at_[joint]);
      if (!(squared <= cutoff * cutoff) || other == joint) continue;
      if (is_renewed_[other] == 0 || joint < other)
        visit(std::min(joint, other), std::max(joint, other), squared);
    }
}

std::vector<OwnDistance> own_distances(const Framework& framework,
                                       std::span<const Vec3> positions) {
  std::vector<OwnDistance> own;
  if (framework.sterics() == nullptr) return own;
  NeighbourList neighbours(framework);
  if (!neighbours.update(positions)) return own;
  for (const NeighbourPair& pair : neighbours.near()) {
    const double apart = distance(positions[pair.a], positions[pair.b]);
    if (apart < pair.least) own.push_back({pair.a, pair.b, apart});
  }
  return own;
}

}  // namespace pliant
