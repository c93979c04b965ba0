// SPDX-License-Identifier: MIT
#include "options/force_file_input.hpp"

#include <algorithm>
#include <array>

#include "options/force_events_input.hpp"
#include "options/force_header_input.hpp"
#include "options/option_fields.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant::app {
namespace {

/// Random pushes are there to compare techniques: what resolves them may be another one.
constexpr std::array<std::string_view, 4> free_settings{"technique", "weighting", "mass_weighted",
                                                        "seed"};

/// A push means nothing without the settings that it was made for.
void expect_settings(const CommandLine& line, const RunSettings& settings, const ForceFile& file) {
  std::string missing;
  const auto expect = [&](bool is_given, const char* option) {
    if (!is_given && !line.was_given(option))
      missing += (missing.empty() ? "" : ", ") + std::string(option);
  };
  expect(file.timestep.has_value(), "--timestep");
  expect(file.tolerance || file.tolerance_length || line.was_given("--tolerance-length"),
         "--tolerance");
  expect(file.max_sweeps.has_value(), "--max-sweeps");
  if (!missing.empty())
    throw InputError(printable_name(settings.job.walkers.forces) +
                     ": lacks settings, which must be given as options: " + missing);
}

/// The settings of a file, one after the other.
class SettingsTaking {
 public:
  SettingsTaking(const CommandLine& line, RunSettings& settings, const ForceFile& file)
      : line_(line), settings_(settings), file_(file) {}

  void take() {
    for (const ForceEvent& event : settings_of(file_)) {
      const auto& set = std::get<SetOption>(event.what);
      RunOptions taken = settings_.job.run;
      try {
        set_run_field(taken, set.name, set.value);
        check_fields(taken);
      } catch (const OptionError& error) {
        fail({settings_.job.walkers.forces, event.line}, error.what());
      }
      take(find_run_field(set.name), taken);
    }
  }

 private:
  void take(const RunField& field, const RunOptions& taken) {
    const bool is_free = std::ranges::count(free_settings, field.name) > 0;
    const bool is_left_to_ordering =
        field.name == "technique" && !settings_.job.walkers.ordering.empty();
    const std::string option = rival_of(field);
    if (is_left_to_ordering || (is_free && line_.was_given(option))) return;
    if (line_.was_given(option)) return compare(option, field, taken);
    settings_.job.run = taken;
    settings_.taken_from_forces.emplace_back(field.name, run_field_text(taken, field));
  }

  /// The option that would replace the setting: of the two kinds of tolerance the one that is
  /// given.
  std::string rival_of(const RunField& field) const {
    if (field.name == "tolerance" && line_.was_given("--tolerance-length"))
      return "--tolerance-length";
    if (field.name == "tolerance_length" && line_.was_given("--tolerance") &&
        !line_.was_given("--tolerance-length"))
      return "--tolerance";
    return option_name(field.name);
  }

  void compare(const std::string& option, const RunField& field, const RunOptions& taken) const {
    std::string name = option.substr(2);
    std::ranges::replace(name, '-', '_');
    const std::string given = run_field_text(settings_.job.run, find_run_field(name));
    const std::string made = run_field_text(taken, field);
    if (name == field.name && given == made) return;
    overrides_forces(settings_, option + " " + given,
                     "with " + option_name(field.name) + " " + made);
  }

  const CommandLine& line_;
  RunSettings& settings_;
  const ForceFile& file_;
};

}  // namespace

void take_forces(const CommandLine& line, RunSettings& settings, const Molecule& molecule) {
  const std::string_view text = without_byte_order_mark(settings.force_text);
  if (has_force_events(text)) return take_events(line, settings, molecule, text);
  ForceFile file = parse_force_file(text, settings.job.walkers.forces, molecule.framework);
  if (file.pushes.empty())
    throw InputError(printable_name(settings.job.walkers.forces) + ": holds no push");
  expect_settings(line, settings, file);
  SettingsTaking(line, settings, file).take();
  RunOptions& run = settings.job.run;
  if (!line.was_given("--steps")) run.steps = static_cast<std::int64_t>(file.pushes.size());
  if (static_cast<std::size_t>(run.steps) > file.pushes.size())
    throw OptionError("--steps: expected at most " + std::to_string(file.pushes.size()) +
                      ", the pushes in " + printable_name(settings.job.walkers.forces));
  run.replay = std::move(file.pushes);
}

}  // namespace pliant::app
