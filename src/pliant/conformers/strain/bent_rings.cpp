// SPDX-License-Identifier: MIT
#include "pliant/conformers/strain/bent_rings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/conformers/strain/torsion_gradient.hpp"
#include "pliant/conformers/torsions/conformer_framework.hpp"

namespace pliant {
namespace {

constexpr double whole = 1e-9, most_bent = 0.3;  // share of a bar's length
constexpr double most_turned = 0.1;              // cosine

/// The largest error of a bar, as a share of its length.
double worst_bar(const Framework& framework, std::span<const Vec3> x) {
  double worst = 0.0;
  for (BarIndex k = 0; k < framework.bar_count(); ++k) {
    const double rest = framework.rest_lengths()[k];
    const Bar bar = framework.bars()[k];
    worst = std::max(worst, std::abs(distance(x[bar.a], x[bar.b]) / rest - 1.0));
  }
  return worst;
}

double torsion_cosine(std::span<const Vec3> x, const std::array<std::size_t, 4>& at) {
  const auto found = torsion_gradient(x[at[0]], x[at[1]], x[at[2]], x[at[3]]);
  return found ? found->cosine : 1.0;
}

/// Whether bonds between flat atoms are turned about as far as at first, to either side.
bool keeps_flat(const FlexibleRing& ring, const BondChemistry& chemistry, const RingForm& first,
                const RingForm& form) {
  const auto is_flat = [&](std::size_t k) { return !chemistry.is_tetrahedral(ring.atoms[k]); };
  for (std::size_t a = 0; a < ring.atoms.size(); ++a)
    for (std::size_t b : ring.neighbours[a])
      for (std::size_t i : ring.neighbours[a])
        for (std::size_t j : ring.neighbours[b]) {
          if (i == b || j == a || i == j || !is_flat(a) || !is_flat(b)) continue;
          const double was = torsion_cosine(first.positions, {i, a, b, j});
          if (std::abs(torsion_cosine(form.positions, {i, a, b, j}) - was) > most_turned)
            return false;
        }
  return true;
}

}  // namespace

std::vector<FlexibleRing> bent_rings(const Framework& molecule, const BondChemistry& chemistry,
                                     std::span<const Vec3> start) {
  const Framework framework = conformer_framework(molecule, start);
  std::vector<FlexibleRing> found;
  for (FlexibleRing& ring : flexible_rings(framework, chemistry, start, {.systems = true})) {
    std::vector<RingForm> bent;
    for (const RingForm& form : ring.forms) {
      std::vector<Vec3> x(start.begin(), start.end());
      take_form(ring, form, x);
      const double worst = worst_bar(framework, x);
      if (worst > whole && worst < most_bent && keeps_flat(ring, chemistry, ring.forms[0], form))
        bent.push_back(form);
    }
    ring.forms = std::move(bent);
    if (!ring.forms.empty()) found.push_back(std::move(ring));
  }
  return found;
}

}  // namespace pliant
