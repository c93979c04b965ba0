// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/conformer_framework.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "pliant/conformers/rings/ring_moves.hpp"
#include "pliant/conformers/torsions/loop_bending.hpp"

namespace pliant {
namespace {

constexpr double soft_angle = 0.12;  // Angstrom
constexpr int softened_bonds = 4;
constexpr double softness = 0.9;  // of least distances
/// Angstrom: heavy atoms come no nearer than 2.6, as frames are whole up to overlaps of 0.08.
constexpr double least_heavy = 2.68;
constexpr std::size_t most_spread = 300;  // atoms: in larger molecules only pairs four bonds apart

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

/// Bonds from `atom` to each heavy atom above it; 0: nearer than four bonds, or farther than
/// `most`.
std::vector<int> bonds_from(Joint atom, int most, const BondChemistry& chemistry) {
  std::vector<int> bonds(chemistry.atoms(), -1);
  std::vector<Joint> reached{atom};
  bonds[atom] = 0;
  for (std::size_t k = 0; k < reached.size() && bonds[reached[k]] < most; ++k)
    for (const Link& bond : chemistry.bonds_at(reached[k])) {
      if (bonds[bond.node] >= 0) continue;
      bonds[bond.node] = bonds[reached[k]] + 1;
      reached.push_back(bond.node);
    }
  for (Joint other = 0; other < bonds.size(); ++other)
    if (other < atom || bonds[other] < softened_bonds || chemistry.is_hydrogen(other))
      bonds[other] = 0;
  return bonds;
}

/// Angles that cannot open bring pairs four bonds apart nearer than they are at rest. Others keep
/// apart even where they could form hydrogen bonds, unless they are nearer at the start.
std::shared_ptr<const Sterics> softened(const Sterics& sterics, const BondChemistry& chemistry,
                                        std::span<const Vec3> start) {
  Sterics soft = sterics;
  const auto has_own = [&](Joint a, Joint b) {
    return std::any_of(sterics.own.begin(), sterics.own.end(), [&](const OwnDistance& own) {
      return std::minmax(own.a, own.b) == std::minmax(a, b);
    });
  };
  const std::size_t atoms = sterics.kinds.size();
  const int most = atoms > most_spread ? softened_bonds : int(atoms);
  for (Joint a = 0; a < atoms; ++a) {
    if (chemistry.is_hydrogen(a)) continue;
    const std::vector<int> bonds = bonds_from(a, most, chemistry);
    for (Joint b = a + 1; b < atoms; ++b) {
      if (bonds[b] == 0) continue;
      const double usual = sterics.of_kinds(a, b);
      const double soft_least = bonds[b] == softened_bonds ? softness * usual : usual;
      const double least = std::max(soft_least, least_heavy);
      if (least == usual || has_own(a, b)) continue;
      if (least < usual || distance(start[a], start[b]) >= least) soft.own.push_back({a, b, least});
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

/// By carbon, then nitrogen.
template <class Turns>
std::vector<Amide> amides_where(const Framework& framework, const BondChemistry& chemistry,
                                const Turns& turns) {
  std::vector<Amide> found;
  if (framework.atoms() == nullptr) return found;
  for (Joint c = 0; c < framework.joint_count(); ++c)
    for (const Link& bond : chemistry.bonds_at(c))
      if (turns(c, bond.node)) found.push_back({c, bond.node});
  return found;
}

/// Amides in large rings that turn.
std::vector<Amide> ring_amides(const Framework& framework, const BondChemistry& chemistry,
                               ConformerMoves moves) {
  return amides_where(framework, chemistry, [&](Joint c, Joint n) {
    return chemistry.is_ring_amide(c, n, !moves.secondary_amides);
  });
}

/// Without bars across amides, those of `in_rings` among them.
Framework framework_with(const Framework& framework, const BondChemistry& chemistry,
                         std::span<const Vec3> start, std::vector<Amide> in_rings,
                         ConformerMoves moves) {
  std::vector<Bar> across;
  for (const std::vector<Amide>& some : {turning_amides(framework, chemistry, moves), in_rings})
    for (const Amide& amide : some)
      for (Bar pair : pairs_across(amide, chemistry)) across.push_back(pair);
  for (Joint c = 0; c < chemistry.atoms(); ++c)
    for (const Link& bond : chemistry.bonds_at(c))
      if (chemistry.is_amidine(c, bond.node))
        for (Bar pair : pairs_across({c, bond.node}, chemistry)) across.push_back(pair);
  const std::vector<Bar> angles = soft_pairs(framework, chemistry, start, moves.ring_systems);
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
  if (parts.sterics != nullptr) parts.sterics = softened(*parts.sterics, chemistry, start);
  return Framework(std::move(parts));
}

/// The plan in which these amides and puckered rings are rigid.
std::optional<BodyPlan> plan_with(const Framework& framework, const BondChemistry& chemistry,
                                  std::span<const Vec3> start, std::span<const Amide> rigid,
                                  ConformerMoves moves) {
  FrameworkParts parts = framework.parts();
  parts.limits.clear();
  parts.sterics.reset();
  parts.drawn.assign(start.begin(), start.end());
  std::vector<Bar> added;
  for (const Amide& amide : rigid) {
    const std::vector<Bar> pairs = pairs_across(amide, chemistry);
    if (!pairs.empty() && !has_bar_of(framework, pairs)) added.push_back(longest_of(pairs, start));
  }
  if (!framework.limits().empty())
    for (Bar pair : limited(framework, soft_pairs(framework, chemistry, start, moves.ring_systems)))
      if (!is_among(pair, added)) added.push_back(pair);
  for (Bar bar : added) {
    parts.bars.push_back(bar);
    parts.rest_lengths.push_back(distance(start[bar.a], start[bar.b]));
  }
  return BodyPlan::make(Framework(std::move(parts)));
}

/// Whether loops can be drawn: those that are bent would twist amides.
bool turns_by_hinges(const Framework& framework, std::span<const Vec3> start,
                     ConformerMoves moves) {
  const std::optional<BodyPlan> plan = drawing_plan(framework, start, moves);
  if (!plan) return false;
  const std::vector<bool> is_in_loop = bodies_in_loops(*plan);
  const auto bodies = plan->bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (is_in_loop[k] && bodies[k].turns() != 1) return false;
  return true;
}

}  // namespace

std::vector<Amide> turning_amides(const Framework& framework, const BondChemistry& chemistry,
                                  ConformerMoves moves) {
  return amides_where(framework, chemistry, [&](Joint c, Joint n) {
    return chemistry.is_tertiary_amide(c, n) ||
           (moves.secondary_amides && chemistry.heavy_bonds_at(n) == 2 && chemistry.is_amide(c, n));
  });
}

Framework conformer_framework(const Framework& framework, std::span<const Vec3> start,
                              ConformerMoves moves) {
  const BondChemistry chemistry(framework, start);
  const std::vector<Amide> in_rings = ring_amides(framework, chemistry, moves);
  if (!in_rings.empty()) {
    Framework made = framework_with(framework, chemistry, start, in_rings, moves);
    if (turns_by_hinges(made, start, moves)) return made;
  }
  return framework_with(framework, chemistry, start, {}, moves);
}

std::optional<BodyPlan> conformer_plan(const Framework& framework, std::span<const Vec3> start,
                                       ConformerMoves moves) {
  const BondChemistry chemistry(framework, start);
  std::vector<Amide> rigid = turning_amides(framework, chemistry, moves);
  for (const Amide& amide : ring_amides(framework, chemistry, moves)) rigid.push_back(amide);
  return plan_with(framework, chemistry, start, rigid, moves);
}

std::optional<BodyPlan> drawing_plan(const Framework& framework, std::span<const Vec3> start,
                                     ConformerMoves moves) {
  const BondChemistry chemistry(framework, start);
  if (ring_amides(framework, chemistry, moves).empty()) return std::nullopt;
  return plan_with(framework, chemistry, start, turning_amides(framework, chemistry, moves), moves);
}

}  // namespace pliant
