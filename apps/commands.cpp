// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <string>

#include "command.hpp"
#include "completion.hpp"
#include "external.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/signals.hpp"
#include "pliant/base/system/terminal.hpp"

namespace pliant::app {
namespace {

// Headings of the help, and of docs/pages/commands.md.
constexpr std::string_view moving = "What moves?";
constexpr std::string_view going = "How does it get there?";
constexpr std::string_view other = "What else could it look like?";
constexpr std::string_view live = "Live";
constexpr std::string_view files = "Files";
constexpr std::string_view method = "The method";

constexpr Command commands[] = {
    {moving, "study", "answer on one page: what is flexible, what moves together, what else",
     nullptr},
    {moving, "sample", "make an ensemble of a protein, or conformers of a small molecule",
     command_sample},
    {moving, "conformers", "make ranked conformers of small molecules: SDF or SMILES in, SDF out",
     nullptr},
    {moving, "analyse", "make an HTML report, figures and tables of a trajectory", nullptr},
    {moving, "rigidity",
     "count degrees of freedom: which parts of a molecule are rigid, which flexible",
     command_rigidity},

    {going, "path", "find a path from one structure of a molecule to another", nullptr},
    {going, "fit", "fit a structure to measured distances between residues", nullptr},
    {going, "design", "say which distances of a molecule to measure", nullptr},
    {going, "run", "push a molecule and restore its bonds, step by step; steer it; follow it live",
     command_run},

    {other, "compare", "compare with NMR models, crystal structures or MD", nullptr},
    {other, "check", "check a trajectory with OpenMM: can it be used to start MD?", nullptr},
    {other, "ensemble", "very many frames in shards, on all cores or many machines", nullptr},

    {live, "play", "pull on a molecule by hand, on a page in the browser", nullptr},
    {live, "watch", "follow a live run in a terminal, over IMD", nullptr},

    {files, "info", "list what is in a molecule file, what was guessed and what is missing",
     command_info},
    {files, "contacts", "list what holds a molecule besides its bonds, such as hydrogen bonds",
     command_contacts},
    {files, "convert", "write a trajectory as DCD, XTC, PDB, SDF, Zarr ...", nullptr},

    {method, "lab", "compare and measure the techniques that restore bonds", command_lab},
};

/// A command that was one, and what does its work now.
struct OldName {
  std::string_view name, now;
};

constexpr OldName old_names[] = {
    {"bench", "pliant lab bench"},
    {"demo", "pliant study --demo"},
    {"experiment", "pliant lab experiment"},
    {"forcegen", "pliant lab forcegen"},
    {"order", "pliant lab order"},
    {"recover", "pliant convert --recover"},
    {"representatives", "pliant convert --representatives N"},
    {"structgen", "pliant lab structgen"},
    {"techniques", "pliant lab techniques"},
};

void print_commands(std::FILE* to) {
  std::string_view group;
  for (const Command& command : commands) {
    if (command.group != group)
      std::fprintf(to, "\n%.*s\n", int(command.group.size()), command.group.data());
    group = command.group;
    std::fprintf(to, "  %-12.*s%.*s\n", int(command.name.size()), command.name.data(),
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
      "examples:\n"
      "  pliant info protein.pdb\n"
      "  pliant sample protein.pdb -o out.h5md\n"
      "  pliant analyse out.h5md\n"
      "  pliant compare out.h5md nmr_models.pdb\n"
      "\n"
      "pliant COMMAND --help explains a command and its usual options, --help-all the others.\n"
      "pliant --completion bash (or zsh, or fish) prints a script that lets your shell complete\n"
      "commands and options. pliant NAME also runs a program called pliant-NAME on your PATH.\n",
      to);
}

int refuse_unknown(const std::string& name) {
  std::fprintf(stderr, "pliant: %s\n", unknown_choice("command", name, names_of(commands)).c_str());
  return exit_usage;
}

int run_external(const std::string& name, const Arguments& arguments) {
  const auto is_it = [&](const Command& command) { return command.name == name; };
  const bool is_ours = std::ranges::any_of(commands, is_it);
  if (!is_ours && find_external(name).empty()) return refuse_unknown(name);
  return run_program(name, arguments);
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
  if (name == "--help" || name == "--help-all" || name == "-h" || name == "help") {
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
  for (const OldName& old : old_names)
    if (old.name == name) throw OptionError(name + ": is " + std::string(old.now) + " now");
  return run_external(name, rest);
}

int fail_with(int code, const char* message) {
  std::fprintf(stderr, "pliant: error: %s\n", printable(message).c_str());
  return code;
}

/// A reader that has gone, as `head` does, is no fault that needs words.
int end_output(int code) {
  errno = 0;
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  if (errno == EPIPE) return exit_failed;
  const std::string reason = error_words(errno == 0 ? EIO : errno);
  return fail_with(exit_failed, ("standard output: " + reason).c_str());
}

}  // namespace

int run_command(const Arguments& words) {
  fail_writes_alone();
  prepare_terminal();
  try {
    return end_output(dispatch(words));
  } catch (const OptionError& error) {
    return fail_with(exit_usage, error.what());
  } catch (const std::bad_alloc&) {
    return fail_with(exit_failed, "out of memory");
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return end_output(exit_failed);
    return fail_with(exit_failed, error.what());
  }
}

}  // namespace pliant::app
