// SPDX-License-Identifier: MIT
// pliant lab: techniques compared, measured and tried on random graphs.
#include <algorithm>
#include <cstdio>

#include "command.hpp"
#include "external.hpp"
#include "pliant/base/choices.hpp"

namespace pliant::app {
namespace {

constexpr Command laboratory[] = {
    {"", "bench", "measure time and error of every technique, and of OpenMM", nullptr},
    {"", "experiment", "compare techniques on random graphs, and judge the claims of the thesis",
     nullptr},
    {"", "structgen", "make random graphs of a class, or a test set of all classes",
     command_structgen},
    {"", "forcegen", "write a force file of random pushes", command_forcegen},
    {"", "order", "write the order in which a technique visits the bars", command_order},
    {"", "techniques", "list techniques, weightings and perturbations", command_techniques},
};

void print_help(std::FILE* to) {
  std::fputs(
      "usage: pliant lab COMMAND [OPTIONS]\n"
      "\n"
      "The laboratory: techniques by which bars are made whole, compared and measured.\n"
      "\n"
      "subcommands:\n",
      to);
  for (const Command& command : laboratory)
    std::fprintf(to, "  %-12.*s%.*s\n", int(command.name.size()), command.name.data(),
                 int(command.summary.size()), command.summary.data());
  std::fputs(
      "\n"
      "options:\n"
      "  -h, --help  print this text and exit\n"
      "\n"
      "pliant lab COMMAND --help explains each.\n"
      "\n"
      "examples:\n"
      "  pliant lab techniques\n"
      "  pliant lab structgen 2-cycle-path -o graph.xml\n"
      "  pliant lab bench throughput protein.pdb\n",
      to);
}

}  // namespace

int command_lab(const Arguments& words) {
  if (words.empty()) {
    print_help(stderr);
    return exit_usage;
  }
  const std::string& name = words[0];
  if (name == "--help" || name == "--help-all" || name == "-h") {
    print_help(stdout);
    return exit_ok;
  }
  const Command& command = choose(laboratory, "command of pliant lab", name);
  const Arguments rest(words.begin() + 1, words.end());
  return command.run != nullptr ? command.run(rest) : run_program("lab-" + name, rest);
}

}  // namespace pliant::app
