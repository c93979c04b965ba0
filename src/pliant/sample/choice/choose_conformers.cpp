// SPDX-License-Identifier: MIT
#include "pliant/sample/choice/choose_conformers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

void check(const ShapeDistances& shapes, std::span<const double> energies,
           const ConformerChoice& choice) {
  if (choice.most < 1) throw OptionError("most = 0: choose at least 1 conformer");
  if (!(choice.rms >= 0.0)) throw OptionError("rms: must be 0 Angstrom or more");
  if (!(choice.window >= 0.0)) throw OptionError("window: must be 0 kcal/mol or more");
  if (energies.size() != shapes.size())
    throw InputError(std::to_string(energies.size()) + " energies for " +
                     std::to_string(shapes.size()) + " conformers");
  if (!std::all_of(energies.begin(), energies.end(), [](double e) { return std::isfinite(e); }))
    throw InputError("energies of conformers must be finite");
}

std::vector<std::size_t> by_energy(std::span<const double> energies) {
  std::vector<std::size_t> order(energies.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return energies[a] < energies[b]; });
  return order;
}

}  // namespace

std::vector<std::size_t> choose_conformers(const ShapeDistances& shapes,
                                           std::span<const double> energies,
                                           const ConformerChoice& choice) {
  check(shapes, energies, choice);
  std::vector<std::size_t> chosen;
  for (std::size_t next : by_energy(energies)) {
    if (chosen.size() == choice.most) break;
    if (!chosen.empty() && energies[next] > energies[chosen[0]] + choice.window) break;
    const bool is_alike = std::any_of(chosen.begin(), chosen.end(), [&](std::size_t known) {
      return shapes.are_within(known, next, choice.rms);
    });
    if (!is_alike) chosen.push_back(next);
  }
  return chosen;
}

}  // namespace pliant
