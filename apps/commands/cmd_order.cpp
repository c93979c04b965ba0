// SPDX-License-Identifier: MIT
// pliant lab order: the ordering file (the thesis' constraint file) of a technique's first sweep.
#include <fmt/format.h>

#include "command.hpp"
#include "messages.hpp"
#include "options/job_options.hpp"
#include "output/json.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/joint_names.hpp"
#include "pliant/jobs/asked/output_options.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant::app {
namespace {

struct OrderSettings {
  MoleculeOptions molecule;
  std::string ordering = "bfs_cycle", root = "0", output;
  std::uint64_t seed = 0;
  bool overwrite = false, json = false;
};

void add_options(CommandLine& line, OrderSettings& settings) {
  add_molecule_options(line, settings.molecule);
  line.start_group("Ordering");
  line.add_choice("--ordering", settings.ordering, names_of(orderings()),
                  "one of those that pliant lab techniques lists");
  line.add_text("--root", settings.root, "JOINT",
                "joint where the ordering begins: its name, or its index from 0");
  line.add_seed("--seed", settings.seed, "seed of random orderings");
  line.start_group("Output");
  line.add_text("-o,--output", settings.output, "FILE", "ordering file (default: print it)");
  line.add_flag("--overwrite", settings.overwrite, "replace an existing file");
  line.add_flag("--json", settings.json, "print one JSON object");
}

Ordering ordering_of(const OrderSettings& settings, const Framework& framework) {
  const OrderingEntry& entry = find_ordering(settings.ordering);
  const Joint root = JointNames(framework).find(settings.root, {"--root"});
  OrderScratch scratch;
  Ordering ordering;
  const RandomKey key{settings.seed, Domain::order, 0, 0, 0};
  entry.order({.framework = framework, .root = root, .key = key}, scratch, ordering);
  return ordering;
}

void print_json(const OrderSettings& settings, const Framework& framework,
                const Ordering& ordering) {
  std::vector<Json> bars;
  for (const OrderedBar& visit : ordering) {
    const Bar bar = framework.bars()[visit.bar];
    const Joint far = visit.near == bar.a ? bar.b : bar.a;
    bars.push_back({{"near", visit.near}, {"far", far}, {"is_tree", visit.is_tree}});
  }
  const Json json{{"input", settings.molecule.input.file},
                  {"ordering", settings.ordering},
                  {"output", settings.output},
                  {"bars", Json::array(bars)}};
  print_json(json);
}

}  // namespace

int command_order(const Arguments& arguments) {
  CommandLine line(
      "pliant lab order",
      "Writes the order in which the first sweep of a technique visits the bars, one bar\n"
      "per line: near joint, far joint, tree or non_tree (closes a cycle). pliant run\n"
      "--ordering takes such a file, edited or not.");
  line.set_footer(
      "Examples:\n"
      "  pliant lab order graph.xml --ordering dfs_cycle --root a\n"
      "  pliant lab order graph.xml -o ordering.txt && pliant run graph.xml --ordering "
      "ordering.txt");
  OrderSettings settings;
  add_options(line, settings);
  line.set_common({"--ordering", "--root", "--seed", "--output", "--overwrite"});
  if (const int code = line.parse(arguments); code >= 0) return code;
  refuse_same_files(inputs_of(settings.molecule), {settings.output});
  Messages messages(settings.json);
  const Molecule molecule = load_molecule(settings.molecule, messages.log());
  const Ordering ordering = ordering_of(settings, molecule.framework);
  const std::string text = write_ordering_file(ordering, molecule.framework);
  if (!settings.output.empty()) write_text_file(path_of(settings.output), text, settings.overwrite);
  if (settings.json) {
    print_json(settings, molecule.framework, ordering);
  } else if (settings.output.empty()) {
    fmt::print("{}", text);
  } else {
    fmt::print("{} bars in {}\n", ordering.size(), printable_name(settings.output));
  }
  return exit_ok;
}

}  // namespace pliant::app
