// SPDX-License-Identifier: MIT
#include "options/job_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "messages.hpp"
#include "options/option_fields.hpp"
#include "output/json.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant::app {
namespace {

std::string known_files(bool takes_graphs) {
  std::string labels;
  for (const Format& format : formats())
    labels.append(labels.empty() ? "" : ", ").append(format.label);
  return labels + " (also .gz, .bz2, .xz)" + (takes_graphs ? ", or a graph (.xml)" : "");
}

void add_file(CommandLine& line, InputOptions& input, bool takes_graphs) {
  line.start_group("Molecule");
  line.add_required_text("input", input.file, "FILE", known_files(takes_graphs));
}

template <class Fields, class Options>
void add_fields(CommandLine& line, const Fields& fields, Options& options) {
  line.start_group(std::string(fields.front().group));
  for (const auto& field : fields)
    if (field.users.command) add_option(line, field, field.place(options));
}

const Parameter* find(const std::vector<NamedParameter>& parameters, const std::string& path) {
  const auto found = std::ranges::find(parameters, path, &NamedParameter::first);
  return found == parameters.end() ? nullptr : &found->second;
}

struct Shown {
  std::string operator()(bool value) const { return value ? "yes" : "no"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return shortest_text(value); }
  std::string operator()(const std::string& value) const {
    return value.empty() ? "none" : value.size() > 200 ? value.substr(0, 200) : value;
  }
};

/// Of how many there are to be in all, and of a choice left to the job, nothing is compared.
bool is_compared(const OptionFacts& facts, const Parameter* given) {
  const auto* text = given ? std::get_if<std::string>(given) : nullptr;
  const bool is_open = text != nullptr && !facts.automatic.empty() && *text == facts.automatic;
  return facts.users.file && facts.name != "frames" && facts.name != "steps" && !is_open;
}

void compare(const std::string& name, const Parameter* given, const std::string& path,
             const H5mdCheckpoint& recorded) {
  const Parameter* there = find(recorded.parameters, path);
  if (given != nullptr && there != nullptr && *given == *there) return;
  throw OptionError(fmt::format("{}: is {} in the run of {}, not {}; a run goes on as it began",
                                name, there ? std::visit(Shown(), *there) : "not set",
                                path_text(recorded.path),
                                given ? std::visit(Shown(), *given) : "that"));
}

/// Puts a JSON value into the place of an option.
struct Put {
  const std::string& name;
  const std::string& file;
  OptionPlace place;

  void operator()(std::int64_t value) const {
    if (auto* real = std::get_if<double*>(&place)) return void(**real = double(value));
    if (auto* seed = std::get_if<std::uint64_t*>(&place); seed && value >= 0)
      return void(**seed = std::uint64_t(value));
    put(value);
  }
  void operator()(const auto& value) const { put(value); }

 private:
  template <class Value>
  void put(const Value& value) const {
    if (auto* same = std::get_if<Value*>(&place)) return void(**same = value);
    constexpr const char* expected[] = {"true or false",  "a whole number", "a whole number",
                                        "a number",       "a text",         "a list of names",
                                        "a list of lists"};
    throw InputError(file + ": " + name + ": expected " + expected[place.index()]);
  }
};

void take_member(CommandLine& line, Job& job, const std::string& name, const JsonMember& value,
                 const std::string& file) {
  std::vector<std::string_view> known;
  for (const OptionRow<Job>& row : job_rows(job.task)) {
    const OptionFacts& facts = *row.facts;
    known.push_back(facts.name);
    if (facts.name != name || !facts.users.job) continue;
    const std::string option = option_name(facts);
    if (!line.was_given(option)) std::visit(Put{name, file, row.place(job)}, value);
    check_option(facts, row.place(job));
    return line.note_given(option);
  }
  throw OptionError(file + ": " + unknown_choice("option", name, known));
}

std::string standard_input() {
  std::string text;
  for (int c = std::getchar(); c != EOF; c = std::getchar()) text += static_cast<char>(c);
  return text;
}

}  // namespace

void add_input_options(CommandLine& line, InputOptions& input, bool takes_graphs) {
  add_file(line, input, takes_graphs);
  add_fields(line, input_fields(), input);
}

void add_model_options(CommandLine& line, ModelAsked& model) {
  line.start_group(std::string(model_fields().front().group));
  for (const ModelField& field : model_fields())
    if (field.use != nullptr && field.name != "free_torsions")
      add_option(line, field, field.place(model));
}

void add_molecule_options(CommandLine& line, MoleculeOptions& molecule) {
  add_input_options(line, molecule.input, true);
  add_fields(line, bars_fields(), molecule.bars);
  add_option(line, model_fields().front(), model_fields().front().place(molecule.model));
  add_model_options(line, molecule.model);
}

void add_job_options(CommandLine& line, Job& job) {
  add_file(line, job.molecule.input, job.task == "run");
  std::string_view group;
  for (const OptionRow<Job>& row : job_rows(job.task)) {
    if (row.facts->group != group) line.start_group(std::string(group = row.facts->group));
    if (row.facts->users.command) add_option(line, *row.facts, row.place(job));
  }
  line.not_required_with("input", "--continue");
}

void take_job_file(CommandLine& line, Job& job, const std::string& file) {
  if (file.empty()) return;
  const bool is_piped = file == "-";
  const std::string text = is_piped ? standard_input() : read_bytes(path_of(file));
  const std::string said = is_piped ? "standard input" : file;
  for (const auto& [name, value] : members_of(text, said)) {
    if (name == "task") {
      if (value != JsonMember(job.task))
        throw InputError(said + ": task: expected \"" + job.task + "\"");
    } else if (name == "input") {
      if (!line.was_given("input")) std::visit(Put{name, said, &job.molecule.input.file}, value);
      line.note_given("input");
    } else {
      take_member(line, job, name, value, said);
    }
  }
  if (job.molecule.input.file.empty() && job.go_on.empty())
    throw InputError(said + ": input: expected the name of a file");
}

void note_given(const CommandLine& line, Job& job) {
  for (const OptionRow<Job>& row : job_rows(job.task))
    if (row.facts->users.job && line.was_given(option_name(*row.facts)))
      job.given.emplace(row.facts->name);
}

int with_errors_as_json(bool is_asked, const std::function<int()>& work) {
  if (!is_asked) return work();
  const auto print = [](const char* kind, const Error& error, int code) {
    print_json({{"error", Json{{"kind", kind}, {"text", error.what()}}}});
    return code;
  };
  try {
    return work();
  } catch (const OptionError& error) {
    return print("OptionError", error, exit_usage);
  } catch (const FileError& error) {
    return print("FileError", error, exit_failed);
  } catch (const Error& error) {
    return print("InputError", error, exit_failed);
  }
}

void add_printing_options(CommandLine& line, Printing& printing) {
  line.add_text(
      "--job", printing.job_file, "FILE",
      "take options that are not given from this JSON file (- for standard input), by\n"
      "their names in Python: {\"input\": \"a.pdb\", \"frames\": 50}; errors are JSON, too");
  line.not_required_with("input", "--job");
  line.add_flag("--dry-run", printing.dry_run,
                "read the input, check all options, and write nothing");
  line.add_flag("--json", printing.json, "print the summary as one JSON object");
  line.add_flag("--quiet", printing.quiet, "print nothing but errors");
  add_verbose(line, printing.verbose);
}

void check_options_again(const CommandLine& line, const Job& given,
                         const std::vector<NamedParameter>& parameters,
                         const H5mdCheckpoint& recorded) {
  if (line.was_given("input"))
    compare("FILE", find(parameters, "input/file"), "input/file", recorded);
  for (const OptionRow<Job>& row : job_rows(given.task)) {
    const OptionFacts& facts = *row.facts;
    const std::string option = option_name(facts);
    if (!facts.users.job || !line.was_given(option)) continue;
    if (!facts.users.again)
      throw OptionError(option + ": does not go with --continue, which adds to " +
                        path_text(recorded.path));
    const Parameter* value = find(parameters, row.path);
    if (is_compared(facts, value)) compare(option, value, row.path, recorded);
  }
  std::error_code error;
  const std::string& output = given.output.output;
  const bool is_another = line.was_given("--output") && output != given.go_on &&
                          !std::filesystem::equivalent(path_of(output), recorded.path, error);
  if (is_another)
    throw OptionError("--output " + output + ": --continue adds to " + given.go_on + " itself");
}

}  // namespace pliant::app
