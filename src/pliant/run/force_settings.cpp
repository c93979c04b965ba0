// SPDX-License-Identifier: MIT
#include "pliant/run/force_settings.hpp"

#include <algorithm>
#include <array>

#include "pliant/run/run_fields.hpp"

namespace pliant {
namespace {

constexpr std::array<std::string_view, 6> kept_elsewhere{
    "steps", "every", "timestep", "tolerance", "tolerance_length", "max_sweeps"};
constexpr std::array<std::string_view, 3> of_perturbation{"perturb", "force", "displacement"};

bool is_in(std::span<const std::string_view> names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

std::vector<ForceSetting> force_settings(const RunOptions& options) {
  std::vector<ForceSetting> settings;
  for (const RunField& field : run_fields()) {
    const std::string text = run_field_text(options, field);
    if (!is_in(kept_elsewhere, field.name) && text != run_field_text(RunOptions(), field))
      settings.push_back({std::string(field.name), text});
  }
  return settings;
}

std::vector<ForceSetting> push_settings(const RunOptions& options) {
  std::vector<ForceSetting> settings = force_settings(options);
  std::erase_if(settings, [&](const ForceSetting& one) {
    const bool is_function = options.technique.sweep && one.name == "technique";
    return is_function || is_in(of_perturbation, one.name);
  });
  return settings;
}

}  // namespace pliant
