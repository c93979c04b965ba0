// SPDX-License-Identifier: MIT
#include "pliant/sample/conformer_framework.hpp"

#include <algorithm>
#include <utility>

namespace pliant {
namespace {

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

bool has_bar_of(const Framework& framework, const std::vector<Bar>& pairs) {
  return std::any_of(pairs.begin(), pairs.end(), [&](Bar pair) {
    const auto around = framework.neighbours(pair.a);
    return std::any_of(around.begin(), around.end(),
                       [&](const Incidence& at) { return at.joint == pair.b; });
  });
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
  FrameworkParts parts = framework.parts();
  parts.bars.clear();
  parts.rest_lengths.clear();
  for (BarIndex k = 0; k < framework.bar_count(); ++k) {
    const Bar bar = framework.bars()[k];
    if (std::any_of(across.begin(), across.end(), [&](Bar pair) { return joins(bar, pair); }))
      continue;
    parts.bars.push_back(bar);
    parts.rest_lengths.push_back(framework.rest_lengths()[k]);
  }
  return Framework(std::move(parts));
}

std::optional<BodyPlan> conformer_plan(const Framework& framework, std::span<const Vec3> start) {
  const BondChemistry chemistry(framework, start);
  FrameworkParts parts = framework.parts();
  parts.limits.clear();
  parts.sterics.reset();
  parts.drawn.assign(start.begin(), start.end());
  for (const Amide& amide : tertiary_amides(framework, chemistry)) {
    const std::vector<Bar> pairs = pairs_across(amide, chemistry);
    if (pairs.empty() || has_bar_of(framework, pairs)) continue;
    const Bar bar = longest_of(pairs, start);
    parts.bars.push_back(bar);
    parts.rest_lengths.push_back(distance(start[bar.a], start[bar.b]));
  }
  return BodyPlan::make(Framework(std::move(parts)));
}

}  // namespace pliant
