// SPDX-License-Identifier: MIT
#include "pliant/resolve/techniques.hpp"

#include <vector>

#include "pliant/base/choices.hpp"
#include "pliant/base/range.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/resolve/automatic.hpp"
#include "pliant/resolve/blocks/blocks.hpp"
#include "pliant/resolve/blocks/ring_sweeps.hpp"
#include "pliant/resolve/froda/froda.hpp"
#include "pliant/resolve/lanes/lane_blocks.hpp"
#include "pliant/resolve/lanes/lane_direct.hpp"
#include "pliant/resolve/lanes/lane_sweeps.hpp"
#include "pliant/resolve/method/method.hpp"
#include "pliant/resolve/sweeps/custom_sweeps.hpp"
#include "pliant/resolve/sweeps/local_sweeps.hpp"
#include "pliant/resolve/sweeps/sweeps.hpp"
#include "pliant/resolve/units/shape_keeper.hpp"
#include "pliant/resolve/units/templates.hpp"
#include "pliant/resolve/units/units.hpp"

namespace pliant {
namespace {

std::vector<TechniqueEntry> all_techniques() {
  std::vector<TechniqueEntry> rows;
  rows.push_back({"auto",
                  "chosen from what the bars form: blocks, units, newton, froda or anderson", false,
                  false, true, make_automatic});
  for (const OrderingEntry& row : orderings())
    rows.push_back(
        {row.name, row.summary, row.forests_only, true, true, make_sweeps, make_lane_sweeps});
  rows.push_back({"bfs_local", "bfs_cycle on the region that a push of one joint disturbs", false,
                  true, true, make_local_sweeps, make_lane_local_sweeps});
  rows.push_back({"blocks",
                  "bridges in one outward pass, exactly; each ring system alone by Newton's method",
                  false, false, false, make_blocks, make_lane_blocks, true});
  rows.push_back({"anderson", "bfs_cycle with Anderson acceleration from sweep to sweep", false,
                  true, true, make_anderson});
  rows.push_back({"rings_first",
                  "each ring system alone by bfs_cycle, then bridges in one outward pass", false,
                  false, true, make_rings_first, nullptr, true});
  rows.push_back({"rings_anderson", "rings_first with Anderson acceleration in each ring system",
                  false, false, true, make_rings_anderson, nullptr, true});
  rows.push_back({"newton", "the nearest whole positions, weighted by mass", false, false, false,
                  make_newton_in_shape, make_lane_newton});
  rows.push_back({"shake",
                  "along the directions of the bars before the push, by inverse mass (SHAKE, CCMA)",
                  false, false, false, make_shake_in_shape, make_lane_shake});
  rows.push_back(
      {"units", "rigid units (angles, small rings) placed exactly in one outward pass over hinges",
       false, false, false, make_units, nullptr, true});
  rows.push_back({"units_nearest",
                  "units, then all hinges turned at once towards where the joints were", false,
                  false, false, make_units_nearest, nullptr, true});
  rows.push_back({"froda",
                  "rigid units turned about their hinges, towards the push and out of contacts",
                  false, false, true, make_froda});
  rows.push_back({"froda_templates",
                  "rigid units and the joints that they share fitted to each other in turn (FRODA)",
                  false, false, true, make_templates});
  return rows;
}

void check_knows_limits(const Technique& technique, const Framework& framework) {
  if (framework.has_bars_only() || entry_of(technique).knows_limits) return;
  std::string known;
  for (const TechniqueEntry& row : techniques())
    if (row.knows_limits) known += (known.empty() ? "" : ", ") + std::string(row.name);
  throw OptionError("technique = " + technique.name + ": does not support limits; use one of " +
                    known);
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

const TechniqueEntry& entry_of(const Technique& technique) {
  static const TechniqueEntry custom{custom_technique,  "sweeps of your own", false, false, true,
                                     make_custom_sweeps};
  return technique.sweep ? custom : find_technique(technique.name);
}

bool shifts_to_mass_centre(const Technique& technique) {
  return technique.mass_weighted && entry_of(technique).carries;
}

void check(const Technique& technique) {
  if (technique.sweep && technique.name != custom_technique)
    throw OptionError("sweep: goes with the technique custom, not with " + technique.name);
  entry_of(technique);
  check_range("weighting", technique.weighting, Range::zero_to_one);
  if (technique.ordering && technique.name != "input")
    throw OptionError("ordering: goes with the technique input, not with " + technique.name);
}

void check(const Technique& technique, const Framework& framework) {
  check(technique);
  check_given_ordering(technique, framework);
  check_knows_limits(technique, framework);
  if (!entry_of(technique).forests_only) return;
  const GraphFacts facts = graph_facts(framework);
  if (facts.is_forest()) return;
  throw OptionError("technique = " + technique.name +
                    ": is for trees only, but the framework has " + std::to_string(facts.cycles) +
                    (facts.cycles == 1 ? " independent cycle" : " independent cycles"));
}

}  // namespace pliant
