// SPDX-License-Identifier: MIT
// pliant lab techniques: the tables that --technique and --perturb choose from.
#include <fmt/format.h>

#include "command.hpp"
#include "command_line.hpp"
#include "output/json.hpp"
#include "pliant/perturb/perturbation.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant::app {
namespace {
Json technique_rows() {
  std::vector<Json> rows;
  for (const TechniqueEntry& row : techniques())
    rows.push_back({{"name", row.name},
                    {"summary", row.summary},
                    {"applies_to", row.forests_only ? "trees" : "any"}});
  return Json::array(rows);
}

Json perturbation_rows() {
  std::vector<Json> rows;
  for (const PerturbationEntry& row : perturbations())
    rows.push_back({{"name", row.name}, {"summary", row.summary}});
  return Json::array(rows);
}

void print_tables() {
  fmt::print("techniques (--technique)\n");
  for (const TechniqueEntry& row : techniques())
    fmt::print("  {:<17}{}{}\n", row.name, row.summary, row.forests_only ? "; trees only" : "");
  fmt::print(
      "\nweighting (--weighting), any number from 0 to 1: the share of a correction that goes to\n"
      "the far end of a tree bar, the one further from the root. 0.5 shares equally, 1 moves it\n"
      "alone. Bars that close a cycle of the traversal are always shared equally.\n"
      "\nperturbations (--perturb)\n");
  for (const PerturbationEntry& row : perturbations())
    fmt::print("  {:<17}{}\n", row.name, row.summary);
}

}  // namespace

int command_techniques(const Arguments& arguments) {
  CommandLine line("pliant lab techniques", "Lists techniques, weightings and perturbations.");
  line.set_footer(
      "Examples:\n"
      "  pliant lab techniques\n"
      "  pliant lab techniques --json\n"
      "  pliant run molecule.sdf --technique newton");
  bool as_json = false;
  line.start_group("Output");
  line.add_flag("--json", as_json, "print one JSON object");
  if (const int code = line.parse(arguments); code >= 0) return code;
  if (as_json) {
    const Json tables{{"techniques", technique_rows()},
                      {"weightings", Json::array({0.5, 0.75, 1.0})},
                      {"perturbations", perturbation_rows()}};
    print_json(tables);
  } else {
    print_tables();
  }
  return exit_ok;
}

}  // namespace pliant::app
