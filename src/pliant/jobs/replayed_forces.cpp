// SPDX-License-Identifier: MIT
#include "pliant/jobs/replayed_forces.hpp"

#include <algorithm>
#include <array>

#include "pliant/base/number.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/jobs/replayed_events.hpp"
#include "pliant/jobs/replayed_header.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant {
namespace {

/// Random pushes are there to compare techniques: what resolves them may be another one.
constexpr std::array<std::string_view, 4> free_settings{"technique", "weighting", "mass_weighted",
                                                        "seed"};

/// A push means nothing without the settings that it was made for.
void expect_settings(const Job& job, const ForceFile& file) {
  std::string missing;
  const auto expect = [&](bool is_given, std::string_view name) {
    if (!is_given && !job.was_given(name))
      missing += (missing.empty() ? "" : ", ") + option_name(name);
  };
  expect(file.timestep.has_value(), "timestep");
  expect(file.tolerance || file.tolerance_length || job.was_given("tolerance_length"), "tolerance");
  expect(file.max_sweeps.has_value(), "max_sweeps");
  if (!missing.empty())
    throw InputError(printable_name(job.walkers.forces) +
                     ": lacks settings, which must be given as options: " + missing);
}

/// The settings of a file, one after the other.
class SettingsTaking {
 public:
  SettingsTaking(Job& job, ReplayedForces& replayed, const ForceFile& file)
      : job_(job), replayed_(replayed), file_(file) {}

  void take() {
    for (const ForceEvent& event : settings_of(file_)) {
      const auto& set = std::get<SetOption>(event.what);
      RunOptions taken = job_.run;
      try {
        set_run_field(taken, set.name, set.value);
        check_fields(taken);
      } catch (const OptionError& error) {
        fail({job_.walkers.forces, event.line}, error.what());
      }
      take(find_run_field(set.name), taken);
    }
  }

 private:
  void take(const RunField& field, const RunOptions& taken) {
    const bool is_free = std::ranges::count(free_settings, field.name) > 0;
    const bool is_left_to_ordering = field.name == "technique" && !job_.walkers.ordering.empty();
    const std::string_view rival = rival_of(field);
    if (is_left_to_ordering || (is_free && job_.was_given(rival))) return;
    if (job_.was_given(rival)) return compare(rival, field, taken);
    job_.run = taken;
    replayed_.taken.emplace_back(field.name, run_field_text(taken, field));
  }

  /// The option that would replace the setting: of the two kinds of tolerance the one that is
  /// given.
  std::string_view rival_of(const RunField& field) const {
    const bool has_length = job_.was_given("tolerance_length");
    if (field.name == "tolerance" && has_length) return "tolerance_length";
    if (field.name == "tolerance_length" && job_.was_given("tolerance") && !has_length)
      return "tolerance";
    return field.name;
  }

  void compare(std::string_view rival, const RunField& field, const RunOptions& taken) const {
    const std::string given = run_field_text(job_.run, find_run_field(rival));
    const std::string made = run_field_text(taken, field);
    if (rival == field.name && given == made) return;
    refuse_contradiction(job_, option_name(rival) + " " + given,
                         "with " + option_name(field.name) + " " + made);
  }

  Job& job_;
  ReplayedForces& replayed_;
  const ForceFile& file_;
};

}  // namespace

void take_forces(Job& job, ReplayedForces& replayed, const RunSubject& subject) {
  const std::string_view text = without_byte_order_mark(replayed.text);
  if (has_force_events(text)) return take_events(job, replayed, subject);
  ForceFile file = parse_force_file(text, job.walkers.forces, subject.framework);
  if (file.pushes.empty()) throw InputError(printable_name(job.walkers.forces) + ": holds no push");
  expect_settings(job, file);
  SettingsTaking(job, replayed, file).take();
  RunOptions& run = job.run;
  if (!job.was_given("steps")) run.steps = static_cast<std::int64_t>(file.pushes.size());
  if (static_cast<std::size_t>(run.steps) > file.pushes.size())
    throw OptionError("--steps: expected at most " + std::to_string(file.pushes.size()) +
                      ", the pushes in " + printable_name(job.walkers.forces));
  run.replay = std::move(file.pushes);
}

}  // namespace pliant
