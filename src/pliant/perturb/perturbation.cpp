// SPDX-License-Identifier: MIT
#include "pliant/perturb/perturbation.hpp"

#include <algorithm>

#include "pliant/base/choices.hpp"

namespace pliant {

std::span<const PerturbationEntry> perturbations() {
  const auto rows = pushers();
  const auto replay = std::find_if(rows.begin(), rows.end(),
                                   [](const PusherEntry& row) { return row.name == "replay"; });
  return {rows.begin(), replay};
}

const PerturbationEntry& find_perturbation(std::string_view name) {
  return choose(perturbations(), "perturbation", name);
}

}  // namespace pliant
