// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include "command.hpp"
#include "completion.hpp"
#include "external.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"

namespace pliant::app {
namespace {

// Headings of the help, and of docs/pages/commands.md.
constexpr std::string_view ensembles = "make an ensemble";
constexpr std::string_view reading = "read it";
constexpr std::string_view structures = "contacts, rigidity and paths";
constexpr std::string_view files = "files";
constexpr std::string_view hands = "steer, pull by hand, follow live";
constexpr std::string_view solvers = "solvers and the thesis";

constexpr Command commands[] = {
    {ensembles, "demo",
     "make a first ensemble, of a helix that comes with Pliant, and say what moves", nullptr},
    {ensembles, "sample", "make an ensemble of a protein, or conformers of a small molecule",
     command_sample},
    {ensembles, "ensemble", "many walkers or frames in shards, on all cores or many machines",
     nullptr},

    {reading, "analyse", "make an HTML report, figures and tables of a trajectory", nullptr},
    {reading, "compare", "compare with NMR models, crystal structures or MD", nullptr},
    {reading, "representatives", "choose a few frames that represent all the others", nullptr},
    {reading, "check", "check a trajectory with OpenMM: may MD start from it?", nullptr},

    {structures, "contacts", "list what holds a molecule besides its bonds, such as hydrogen bonds",
     command_contacts},
    {structures, "rigidity",
     "count degrees of freedom: which parts of a molecule are rigid, which flexible",
     command_rigidity},
    {structures, "path", "find a path from one structure of a molecule to another", nullptr},

    {files, "info", "list what is in a molecule file, what was guessed and what is missing",
     command_info},
    {files, "convert", "write a trajectory as DCD, XTC, TRR, XYZ or PDB", nullptr},
    {files, "recover", "copy whatever can be read of a damaged trajectory", nullptr},

    {hands, "run", "push a molecule and restore its bonds, step by step; steer it; follow it live",
     command_run},
    {hands, "play", "pull on a molecule by hand, on a page in the browser", nullptr},
    {hands, "watch", "follow a live run in a terminal, over IMD", nullptr},

    {solvers, "techniques", "list techniques, weightings and perturbations", command_techniques},
    {solvers, "order", "write the order in which a technique visits the bars", command_order},
    {solvers, "forcegen", "write a force file of random pushes", command_forcegen},
    {solvers, "structgen", "make random graphs of a class, or a test set of all classes",
     command_structgen},
    {solvers, "experiment",
     "compare techniques on random graphs, and judge the claims of the thesis", nullptr},
    {solvers, "bench", "measure time and error of every technique, and of OpenMM", nullptr},
};

void print_commands(std::FILE* to) {
  std::string_view group;
  for (const Command& command : commands) {
    if (command.group != group)
      std::fprintf(to, "\n%.*s:\n", int(command.group.size()), command.group.data());
    group = command.group;
    std::fprintf(to, "  %-17.*s%.*s\n", int(command.name.size()), command.name.data(),
                 int(command.summary.size()), command.summary.data());
  }
}

void print_usage(std::FILE* to) {
  std::fputs(
      "pliant: molecular flexibility by geometric constraints\n"
      "\n"
      "usage: pliant COMMAND [OPTIONS]\n",
      to);
  print_commands(to);
  std::fputs(
      "\n"
      "words:\n"
      "  joint            a point: an atom, if the input is a molecule\n"
      "  bar              two joints at a fixed distance: a bond, or the two ends of a bond angle\n"
      "  residual         how far a bar is from its length; a bar within the tolerance is whole\n"
      "  technique        a way to resolve broken bars, that is, to make them whole again\n"
      "  sweep            one visit to all bars, one after another; most techniques make many\n"
      "  walker           one of several independent copies of a molecule\n"
      "\n"
      "pliant NAME also runs a program called pliant-NAME on your PATH.\n"
      "\n"
      "examples:\n"
      "  pliant info protein.pdb\n"
      "  pliant sample protein.pdb -o out.h5md\n"
      "  pliant analyse out.h5md\n"
      "  pliant compare out.h5md nmr_models.pdb\n"
      "\n"
      "pliant COMMAND --help explains a command. pliant --completion bash (or zsh, or fish) "
      "prints\n"
      "a script that lets your shell complete commands and options.\n",
      to);
}

int refuse_unknown(const std::string& name) {
  std::fprintf(stderr, "pliant: %s\n", unknown_choice("command", name, names_of(commands)).c_str());
  return exit_usage;
}

int run_external(const std::string& name, const Arguments& arguments) {
  const std::string path = find_external(name);
  for (const Command& command : commands) {
    if (command.name != name || !path.empty()) continue;
    std::fprintf(stderr,
                 "pliant: %s is part of the Python package: install it (pip install pliant), "
                 "so that pliant-%s is on PATH\n",
                 name.c_str(), name.c_str());
    return exit_failed;
  }
  if (path.empty()) return refuse_unknown(name);
  become(path, arguments);
  std::perror(("pliant: " + path).c_str());
  return exit_failed;
}

int print_completion(const Arguments& words) {
  if (words.size() != 1) throw OptionError("--completion: expected bash, zsh or fish after it");
  std::fputs(completion_script(words[0], commands).c_str(), stdout);
  return exit_ok;
}

int dispatch(const Arguments& words) {
  if (words.empty()) {
    print_usage(stderr);
    return exit_usage;
  }
  const std::string& name = words[0];
  if (name == "--help" || name == "-h" || name == "help") {
    print_usage(stdout);
    return exit_ok;
  }
  if (name == "--version") {
    std::puts("pliant " PLIANT_VERSION);
    return exit_ok;
  }
  const Arguments rest(words.begin() + 1, words.end());
  if (name == "--completion") return print_completion(rest);
  for (const Command& command : commands)
    if (command.name == name && command.run != nullptr) return command.run(rest);
  return run_external(name, rest);
}

int fail_with(int code, const char* message) {
  std::fprintf(stderr, "pliant: error: %s\n", printable(message).c_str());
  return code;
}

}  // namespace

int run_command(int argc, char** argv) {
  // A closed pipe or a full quota is an error of the write that meets it, not the end of the run.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int code = dispatch({argv + 1, argv + argc});
    return std::fflush(stdout) == 0 ? code : int{exit_failed};
  } catch (const OptionError& error) {
    return fail_with(exit_usage, error.what());
  } catch (const std::bad_alloc&) {
    return fail_with(exit_failed, "out of memory");
  } catch (const std::exception& error) {
    return fail_with(exit_failed, error.what());
  }
}

}  // namespace pliant::app
