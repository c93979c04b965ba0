// SPDX-License-Identifier: MIT
#include "pliant/resolve/techniques.hpp"

#include <iterator>
#include <vector>

#include "pliant/base/choices.hpp"
#include "pliant/base/range.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/resolve/auto.hpp"
#include "pliant/resolve/blocks/blocks.hpp"
#include "pliant/resolve/bodies/local_steps.hpp"
#include "pliant/resolve/bodies/shape_keeper.hpp"
#include "pliant/resolve/lanes/lane_blocks.hpp"
#include "pliant/resolve/lanes/lane_direct.hpp"
#include "pliant/resolve/lanes/lane_sweeps.hpp"
#include "pliant/resolve/method/method.hpp"
#include "pliant/resolve/sweeps/anderson_sweeps.hpp"
#include "pliant/resolve/sweeps/custom_sweeps.hpp"
#include "pliant/resolve/sweeps/sweeps.hpp"

namespace pliant {
namespace {

constexpr TechniqueEntry auto_entry{
    .name = "auto",
    .summary = "chosen from what the bars form: blocks, units, newton, froda or anderson",
    .has_weighting = false,
    .knows_limits = true,
    .make = make_automatic};

TechniqueEntry entry_of_ordering(const OrderingEntry& row) {
  return {.name = row.name,
          .summary = row.summary,
          .forests_only = row.forests_only,
          .knows_limits = true,
          .make = make_sweeps,
          .make_lanes = make_lane_sweeps,
          .bar_by_bar = true};
}

constexpr TechniqueEntry method_entries[] = {
    {.name = "blocks",
     .summary = "bridges in one outward pass, exactly; each ring system alone by Newton's method",
     .has_weighting = false,
     .make = make_blocks,
     .make_lanes = make_lane_blocks,
     .carries = true},
    {.name = "anderson",
     .summary = "bfs_cycle with Anderson acceleration from sweep to sweep",
     .knows_limits = true,
     .make = make_anderson,
     .bar_by_bar = true},
    {.name = "newton",
     .summary = "the nearest whole positions, weighted by mass",
     .has_weighting = false,
     .make = make_newton_in_shape,
     .make_lanes = make_lane_newton},
    {.name = "shake",
     .summary = "along the directions of the bars before the push, by inverse mass (SHAKE, CCMA)",
     .has_weighting = false,
     .make = make_shake_in_shape,
     .make_lanes = make_lane_shake},
    {.name = "units",
     .summary = "rigid units (angles, small rings) placed exactly in one outward pass over hinges",
     .has_weighting = false,
     .make = make_local_units,
     .carries = true},
    {.name = "froda",
     .summary = "rigid units turned about their hinges, towards the push and out of contacts",
     .has_weighting = false,
     .knows_limits = true,
     .make = make_local_froda},
};

constexpr TechniqueEntry custom_entry{.name = custom_technique,
                                      .summary = "sweeps of your own",
                                      .has_weighting = false,
                                      .knows_limits = true,
                                      .make = make_custom_sweeps};

std::vector<TechniqueEntry> all_techniques() {
  std::vector<TechniqueEntry> rows{auto_entry};
  for (const OrderingEntry& row : orderings()) rows.push_back(entry_of_ordering(row));
  rows.insert(rows.end(), std::begin(method_entries), std::end(method_entries));
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
  return technique.sweep ? custom_entry : find_technique(technique.name);
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
