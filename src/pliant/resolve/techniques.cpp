// SPDX-License-Identifier: MIT
#include "pliant/resolve/techniques.hpp"

#include <vector>

#include "pliant/base/choices.hpp"
#include "pliant/base/range.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/resolve/automatic.hpp"
#include "pliant/resolve/blocks/blocks.hpp"
#include "pliant/resolve/froda/froda.hpp"
#include "pliant/resolve/lanes/lane_blocks.hpp"
#include "pliant/resolve/lanes/lane_direct.hpp"
#include "pliant/resolve/lanes/lane_sweeps.hpp"
#include "pliant/resolve/method/method.hpp"
#include "pliant/resolve/sweeps/anderson_sweeps.hpp"
#include "pliant/resolve/sweeps/custom_sweeps.hpp"
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
    rows.push_back({row.name, row.summary, row.forests_only, true, true, make_sweeps,
                    make_lane_sweeps, false, true});
  rows.push_back({"blocks",
                  "bridges in one outward pass, exactly; each ring system alone by Newton's method",
                  false, false, false, make_blocks, make_lane_blocks, true});
  rows.push_back({"anderson", "bfs_cycle with Anderson acceleration from sweep to sweep", false,
                  true, true, make_anderson, nullptr, false, true});
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

std::string without_limits(const Technique& technique) {
  std::string known;
  for (const TechniqueEntry& row : techniques())
    if (row.knows_limits) known += (known.empty() ? "" : ", ") + std::string(row.name);
  return "technique = " + technique.name + ": does not support limits; use one of " + known;
}

std::string for_trees_only(const Technique& technique, std::size_t cycles) {
  return "technique = " + technique.name + ": is for trees only, but the framework has " +
         std::to_string(cycles) + (cycles == 1 ? " independent cycle" : " independent cycles");
}

/// Why a technique cannot resolve a framework; "": it may.
std::string refusal(const Technique& technique, const Framework& framework) {
  const TechniqueEntry& row = entry_of(technique);
  if (!framework.has_bars_only() && !row.knows_limits) return without_limits(technique);
  if (!row.forests_only) return "";
  const GraphFacts facts = graph_facts(framework);
  return facts.is_forest() ? "" : for_trees_only(technique, facts.cycles);
}

std::string too_slow(const Technique& technique, const Framework& framework) {
  return "technique = " + technique.name +
         ": goes from bar to bar, which does not converge or is slow where bars form rigid units "
         "(angles); use auto, which takes " +
         choose_technique(framework, technique).technique.name;
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

TechniqueFit fit_of(const Technique& technique, const Framework& framework) {
  if (std::string why = refusal(technique, framework); !why.empty())
    return {Fit::refused, std::move(why)};
  if (entry_of(technique).bar_by_bar && forms_rigid_units(framework))
    return {Fit::doubtful, too_slow(technique, framework)};
  return {};
}

void warn_if_doubtful(const Technique& technique, const Framework& framework, const Log& log) {
  if (!log.function) return;
  const TechniqueFit found = fit_of(technique, framework);
  if (found.fit == Fit::doubtful) log.warn(found.why);
}

void check(const Technique& technique, const Framework& framework) {
  check(technique);
  check_given_ordering(technique, framework);
  if (const std::string why = refusal(technique, framework); !why.empty()) throw OptionError(why);
}

}  // namespace pliant
