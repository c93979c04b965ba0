// SPDX-License-Identifier: MIT
// pliant techniques: the tables that --technique and --perturb choose from.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "options.hpp"
#include "pliant/perturb/perturbation.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant::app {
namespace {

using Json = nlohmann::ordered_json;

Json technique_rows() {
  Json rows = Json::array();
  for (const TechniqueEntry& row : techniques())
    rows.push_back({{"name", row.name},
                    {"summary", row.summary},
                    {"applies_to", row.forests_only ? "trees" : "any"}});
  return rows;
}

Json perturbation_rows() {
  Json rows = Json::array();
  for (const PerturbationEntry& row : perturbations())
    rows.push_back({{"name", row.name}, {"summary", row.summary}});
  return rows;
}

void print_table() {
  fmt::print("techniques (--technique)\n");
  for (const TechniqueEntry& row : techniques())
    fmt::print("  {:<15}{}{}\n", row.name, row.summary, row.forests_only ? "; trees only" : "");
  fmt::print(
      "\nweighting (--weighting), any number from 0 to 1: the share of a correction that the end\n"
      "of a tree bar further from the root takes. 0.5 shares alike, 1 moves the far end alone.\n"
      "Bars that close a cycle of the traversal are always shared alike.\n"
      "\nperturbations (--perturb)\n");
  for (const PerturbationEntry& row : perturbations())
    fmt::print("  {:<15}{}\n", row.name, row.summary);
}

}  // namespace

int command_techniques(const Arguments& arguments) {
  CLI::App app{"Lists techniques, weightings and perturbations.", "pliant techniques"};
  prepare(app);
  bool as_json = false;
  start_group(app, "Output");
  app.add_flag("--json", as_json, "print one JSON object");
  if (const int code = parse(app, arguments); code >= 0) return code;
  if (as_json) {
    const Json tables{{"techniques", technique_rows()},
                      {"weightings", {0.5, 0.75, 1.0}},
                      {"perturbations", perturbation_rows()}};
    fmt::print("{}\n", tables.dump(2));
  } else {
    print_table();
  }
  return exit_ok;
}

}  // namespace pliant::app
