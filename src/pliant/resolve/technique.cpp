// SPDX-License-Identifier: MIT
#include "pliant/resolve/technique.hpp"

#include <vector>

#include "pliant/base/choices.hpp"
#include "pliant/base/number.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/resolve/automatic.hpp"
#include "pliant/resolve/blocks.hpp"
#include "pliant/resolve/lane_blocks.hpp"
#include "pliant/resolve/lane_direct.hpp"
#include "pliant/resolve/lane_sweeps.hpp"
#include "pliant/resolve/local_sweeps.hpp"
#include "pliant/resolve/method.hpp"
#include "pliant/resolve/newton.hpp"
#include "pliant/resolve/ring_sweeps.hpp"
#include "pliant/resolve/shake.hpp"
#include "pliant/resolve/sweeps.hpp"
#include "pliant/resolve/units.hpp"

namespace pliant {
namespace {

std::vector<TechniqueEntry> all_techniques() {
  std::vector<TechniqueEntry> rows;
  rows.push_back({"auto", "chosen by what the bars form: blocks, units, newton or anderson", false,
                  false, make_automatic});
  for (const OrderingEntry& row : orderings())
    rows.push_back({row.name, row.summary, row.forests_only, true, make_sweeps, make_lane_sweeps});
  rows.push_back({"bfs_local", "bfs_cycle, of the region that a push of one joint disturbs", false,
                  true, make_local_sweeps, make_lane_local_sweeps});
  rows.push_back({"blocks",
                  "bridges exact in one outward pass, each ring system alone by Newton's method",
                  false, false, make_blocks, make_lane_blocks});
  rows.push_back({"anderson", "bfs_cycle with Anderson acceleration from sweep to sweep", false,
                  true, make_anderson});
  rows.push_back({"rings_first",
                  "each ring system alone by bfs_cycle, then bridges in one outward pass", false,
                  false, make_rings_first});
  rows.push_back({"rings_anderson", "rings_first with Anderson acceleration in each ring system",
                  false, false, make_rings_anderson});
  rows.push_back({"newton", "the nearest whole positions, weighted by mass", false, false,
                  make_newton, make_lane_newton});
  rows.push_back({"shake",
                  "along the bars as they were before the push, by inverse mass (SHAKE, CCMA)",
                  false, false, make_shake, make_lane_shake});
  rows.push_back(
      {"units", "rigid units (angles, small rings) placed exactly in one outward pass over hinges",
       false, false, make_units});
  rows.push_back({"units_nearest",
                  "units, then all hinges turned at once towards where the joints were", false,
                  false, make_units_nearest});
  return rows;
}

void check_given_ordering(const Technique& technique, const Framework& framework) {
  if (!technique.ordering) return;
  const std::string fault = check_ordering(framework, *technique.ordering, {.tree_bars = false});
  if (!fault.empty()) throw OptionError("ordering: " + fault);
}

}  // namespace

std::span<const TechniqueEntry> techniques() {
  static const std::vector<TechniqueEntry> rows = all_techniques();
  return rows;
}

const TechniqueEntry& find_technique(std::string_view name) {
  return choose(techniques(), "technique", name);
}

void check(const Technique& technique) {
  find_technique(technique.name);
  if (!(technique.weighting >= 0.0 && technique.weighting <= 1.0))
    throw OptionError("weighting = " + number_text(technique.weighting) + ": must be from 0 to 1");
  if (technique.ordering && technique.name != "input")
    throw OptionError("ordering: goes with the technique input, not with " + technique.name);
}

void check(const Technique& technique, const Framework& framework) {
  check(technique);
  check_given_ordering(technique, framework);
  if (!find_technique(technique.name).forests_only) return;
  const GraphFacts facts = graph_facts(framework);
  if (facts.is_forest()) return;
  throw OptionError("technique = " + technique.name +
                    ": is for trees only, but the framework has " + std::to_string(facts.cycles) +
                    (facts.cycles == 1 ? " independent cycle" : " independent cycles"));
}

std::pair<double, double> shares(const Technique& technique, const OrderedBar& visit,
                                 const Framework& framework) {
  const Bar bar = framework.bars()[visit.bar];
  const Joint far_joint = visit.near == bar.a ? bar.b : bar.a;
  const bool near_pinned = framework.is_pinned(visit.near);
  const bool far_pinned = framework.is_pinned(far_joint);
  if (near_pinned || far_pinned)
    return {near_pinned ? 0.0 : 1.0, far_pinned ? 0.0 : (near_pinned ? 1.0 : 0.0)};
  double far = visit.is_tree ? technique.weighting : 0.5;
  double near = 1.0 - far;
  if (technique.mass_weighted) {
    near *= framework.inverse_masses()[visit.near];
    far *= framework.inverse_masses()[far_joint];
  }
  return {near / (near + far), far / (near + far)};
}

}  // namespace pliant
