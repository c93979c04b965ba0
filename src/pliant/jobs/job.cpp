// SPDX-License-Identifier: MIT
#include "pliant/jobs/job.hpp"

#include <algorithm>
#include <filesystem>

#include "pliant/base/choices.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/threads/threads.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant {
namespace {

using Rows = std::vector<OptionRow<Job>>;

void add_input(Rows& rows) {
  append_rows(rows, "input", input_fields(),
              [](Job& job) -> InputOptions& { return job.molecule.input; });
}

void add_model(Rows& rows) {
  append_rows(rows, "model", model_fields(),
              [](Job& job) -> ModelAsked& { return job.molecule.model; });
}

void add_output(Rows& rows) {
  append_rows(rows, "record", output_fields(),
              [](Job& job) -> OutputOptions& { return job.output; });
}

constexpr OptionFacts go_on_facts(std::string_view group, std::string_view summary) {
  return {.name = "continue",
          .group = group,
          .summary = summary,
          .kind = "FILE",
          .users = {.python = false, .page = false, .file = false}};
}
constexpr OptionFacts sample_goes_on = go_on_facts(
    "Sampling", "continue this trajectory, up to --frames in total, as if it had never stopped");
constexpr OptionFacts run_goes_on = go_on_facts(
    "Run", "continue this trajectory, up to --steps in total, as if it had never stopped");

void add_go_on(Rows& rows, const OptionFacts& facts) {
  rows.push_back({&facts, "", [](Job& job) -> OptionPlace { return &job.go_on; }});
}

Rows rows_of_sample() {
  Rows rows;
  add_input(rows);
  add_model(rows);
  append_rows(rows, "sample", sample_fields(),
              [](Job& job) -> SampleOptions& { return job.sample; });
  add_go_on(rows, sample_goes_on);
  add_output(rows);
  return rows;
}

/// Groups of the help stay together: the walkers' options are among those of the run.
Rows rows_of_run() {
  Rows rows;
  add_input(rows);
  append_rows(rows, "input", bars_fields(),
              [](Job& job) -> BarsAsked& { return job.molecule.bars; });
  add_model(rows);
  std::erase_if(rows, [](const auto& row) { return row.facts->name == "free_torsions"; });
  const std::size_t first = rows.size();
  append_rows(rows, "run", run_fields(), [](Job& job) -> RunOptions& { return job.run; });
  append_rows(rows, "run", walkers_fields(), [](Job& job) -> WalkersAsked& { return job.walkers; });
  add_go_on(rows, run_goes_on);
  const auto rank = [](const OptionRow<Job>& row) {
    const std::string_view groups[] = {"Run", "Technique", "Perturbation"};
    return std::ranges::find(groups, row.facts->group) - groups;
  };
  std::ranges::stable_sort(rows.begin() + std::ptrdiff_t(first), rows.end(), {}, rank);
  append_rows(rows, "guide", guide_fields(), [](Job& job) -> GuideAsked& { return job.guide; });
  add_output(rows);
  return rows;
}

/// What prepares one ligand goes along. A library may be larger than the file of a molecule.
Rows rows_of_conformers() {
  Rows rows;
  append_rows(rows, "conformers", conformer_fields(),
              [](Job& job) -> ConformerOptions& { return job.conformers; });
  add_input(rows);
  std::erase_if(rows, [](const auto& row) { return row.path == "input/max_input"; });
  for (const ModelField& field : model_fields())
    if (field.use == &ModelEntry::is_prepared && field.name != "free_torsions")
      append_rows(rows, "model", std::span(&field, 1),
                  [](Job& job) -> ModelAsked& { return job.molecule.model; });
  return rows;
}

/// A task and its rows.
struct TaskEntry {
  std::string_view name;
  Rows rows;
};

const TaskEntry& entry_of(std::string_view task) {
  static const TaskEntry tasks[] = {
      {"sample", rows_of_sample()}, {"run", rows_of_run()}, {"conformers", rows_of_conformers()}};
  return choose(tasks, "task", task);
}

}  // namespace

Job usual_job(std::string_view task) {
  Job job;
  job.task = entry_of(task).name;
  job.sample.threads = job.conformers.threads = all_processors();
  if (task == "sample") job.molecule.model.model = automatic_model;
  return job;
}

std::span<const OptionRow<Job>> job_rows(std::string_view task) { return entry_of(task).rows; }

std::vector<NamedParameter> parameters_of(const Job& job) {
  std::vector<NamedParameter> values{
      {"input/file", path_text(path_of(job.molecule.input.file).filename())}};
  Job& places = places_of(job);
  const bool has_model = !job.molecule.model.model.empty();
  for (const OptionRow<Job>& row : job_rows(job.task)) {
    const bool is_of_model = row.path.starts_with("model/");
    if (!row.facts->users.file || (is_of_model && !has_model)) continue;
    values.emplace_back(row.path, parameter_of(*row.facts, row.place(places)));
  }
  return values;
}

}  // namespace pliant
