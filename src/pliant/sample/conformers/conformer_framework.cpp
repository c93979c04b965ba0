// SPDX-License-Identifier: MIT
#include "pliant/sample/conformers/conformer_framework.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "pliant/sample/rings/ring_moves.hpp"

namespace pliant {
namespace {

constexpr double soft_angle = 0.12;  // Angstrom
constexpr int softened_bonds = 4;
constexpr double softness = 0.9;    // of least distances
constexpr double least_soft = 2.6;  // Angstrom: heavy atoms come no nearer

/// Pairs of atoms across an amide: at its carbon and at its nitrogen.
std::vector<Bar> pairs_across(const Amide& amide, const BondChemistry& chemistry) {
  std::vector<Bar> pairs;
  for (const Link& one : chemistry.bonds_at(amide.carbon))
    for (const Link& other : chemistry.bonds_at(amide.nitrogen))
      if (one.node != amide.nitrogen && other.node != amide.carbon)
        pairs.push_back({std::min(one.node, other.node), std::max(one.node, other.node)});
  return pairs;
}

bool joins(Bar bar, Bar pair) { return std::minmax(bar.a, bar.b) == std::minmax(pair.a, pair.b); }

bool is_among(Bar bar, const std::vector<Bar>& pairs) {
  return std::any_of(pairs.begin(), pairs.end(), [&](Bar pair) { return joins(bar, pair); });
}

/// Pairs of these that limits hold.
std::vector<Bar> limited(const Framework& framework, const std::vector<Bar>& pairs) {
  std::vector<Bar> found;
  for (const Limit& limit : framework.limits())
    if (const Bar pair{limit.a, limit.b}; is_among(pair, pairs) && !is_among(pair, found))
      found.push_back(pair);
  return found;
}

bool has_bar_of(const Framework& framework, const std::vector<Bar>& pairs) {
  return std::any_of(pairs.begin(), pairs.end(), [&](Bar pair) {
    const auto around = framework.neighbours(pair.a);
    return std::any_of(around.begin(), around.end(),
                       [&](const Incidence& at) { return at.joint == pair.b; });
  });
}

/// Heavy atoms above `atom` that are four bonds away.
std::vector<Joint> four_bonds_from(Joint atom, const BondChemistry& chemistry) {
  std::vector<Joint> reached{atom};
  std::size_t begin = 0;
  for (int depth = 0; depth < softened_bonds; ++depth) {
    const std::size_t end = reached.size();
    for (std::size_t k = begin; k < end; ++k)
      for (const Link& bond : chemistry.bonds_at(reached[k]))
        if (std::find(reached.begin(), reached.end(), bond.node) == reached.end())
          reached.push_back(bond.node);
    begin = end;
  }
  reached.erase(reached.begin(), reached.begin() + std::ptrdiff_t(begin));
  std::erase_if(reached, [&](Joint other) { return other < atom || chemistry.is_hydrogen(other); });
  std::sort(reached.begin(), reached.end());
  return reached;
}

/// Angles that cannot open bring such pairs nearer than they are at rest.
std::shared_ptr<const Sterics> softened(const Sterics& sterics, const BondChemistry& chemistry) {
  Sterics soft = sterics;
  const auto has_own = [&](Joint a, Joint b) {
    return std::any_of(sterics.own.begin(), sterics.own.end(), [&](const OwnDistance& own) {
      return std::minmax(own.a, own.b) == std::minmax(a, b);
    });
  };
  for (Joint a = 0; a < sterics.kinds.size(); ++a) {
    if (chemistry.is_hydrogen(a)) continue;
    for (Joint b : four_bonds_from(a, chemistry)) {
      const double usual = sterics.of_kinds(a, b);
      const double least = std::max(softness * usual, std::min(usual, least_soft));
      if (least < usual && !has_own(a, b)) soft.own.push_back({a, b, least});
    }
  }
  return std::make_shared<const Sterics>(std::move(soft));
}

/// Short pairs hold a torsion badly: its sine is small there.
Bar longest_of(const std::vector<Bar>& pairs, std::span<const Vec3> x) {
  return *std::max_element(pairs.begin(), pairs.end(), [&](Bar one, Bar other) {
    return distance(x[one.a], x[one.b]) < distance(x[other.a], x[other.b]);
  });
}

}  // namespace

std::vector<Amide> tertiary_amides(const Framework& framework, const BondChemistry& chemistry) {
  std::vector<Amide> found;
  if (framework.atoms() == nullptr) return found;
  for (Joint c = 0; c < framework.joint_count(); ++c)
    for (const Link& bond : chemistry.bonds_at(c))
      if (chemistry.is_tertiary_amide(c, bond.node)) found.push_back({c, bond.node});
  return found;
}

Framework conformer_framework(const Framework& framework, std::span<const Vec3> start) {
  const BondChemistry chemistry(framework, start);
  std::vector<Bar> across;
  for (const Amide& amide : tertiary_amides(framework, chemistry))
    for (Bar pair : pairs_across(amide, chemistry)) across.push_back(pair);
  const std::vector<Bar> angles = soft_pairs(framework, chemistry, start);
  FrameworkParts parts = framework.parts();
  parts.bars.clear();
  parts.rest_lengths.clear();
  for (BarIndex k = 0; k < framework.bar_count(); ++k) {
    const Bar bar = framework.bars()[k];
    if (is_among(bar, across)) continue;
    const double length = framework.rest_lengths()[k];
    if (is_among(bar, angles)) {
      parts.limits.push_back(
          {.a = bar.a, .b = bar.b, .least = length - soft_angle, .most = length + soft_angle});
      continue;
    }
    parts.bars.push_back(bar);
    parts.rest_lengths.push_back(length);
  }
  if (parts.sterics != nullptr) parts.sterics = softened(*parts.sterics, chemistry);
  return Framework(std::move(parts));
}

std::optional<BodyPlan> conformer_plan(const Framework& framework, std::span<const Vec3> start) {
  const BondChemistry chemistry(framework, start);
  FrameworkParts parts = framework.parts();
  parts.limits.clear();
  parts.sterics.reset();
  parts.drawn.assign(start.begin(), start.end());
  std::vector<Bar> added;
  for (const Amide& amide : tertiary_amides(framework, chemistry)) {
    const std::vector<Bar> pairs = pairs_across(amide, chemistry);
    if (!pairs.empty() && !has_bar_of(framework, pairs)) added.push_back(longest_of(pairs, start));
  }
  if (!framework.limits().empty())
    for (Bar pair : limited(framework, soft_pairs(framework, chemistry, start)))
      if (!is_among(pair, added)) added.push_back(pair);
  for (Bar bar : added) {
    parts.bars.push_back(bar);
    parts.rest_lengths.push_back(distance(start[bar.a], start[bar.b]));
  }
  return BodyPlan::make(Framework(std::move(parts)));
}

}  // namespace pliant
