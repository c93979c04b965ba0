// SPDX-License-Identifier: MIT
#include "output/conformations.hpp"

#include "pliant/conformers/torsions/torsion_moves.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant::app {
namespace {

std::string ring_names(const Framework& framework, const std::vector<Joint>& atoms) {
  std::string names;
  for (Joint atom : atoms) names += (names.empty() ? "" : " ") + framework.label(atom);
  return names;
}

}  // namespace

std::optional<Conformations> conformations_of(const Job& job, const SampledSystem& system) {
  if (find_sampler(job.sample.sampler).has_amplitude) return std::nullopt;
  const Framework& framework = system.framework;
  const ConformerMoves may_move = conformer_moves(job.sample);
  const auto plan = conformer_plan(framework, system.start, may_move);
  if (!plan) return std::nullopt;
  const TorsionMoves moves(framework, *plan, system.start, may_move);
  Conformations found{{}, {}, {}, {}, {}, {}, moves.loop_bodies(), moves.bent() == nullptr};
  for (const Rotor& rotor : moves.rotors()) {
    const bool is_held = rotor.kind == BondTurn::atropisomer;
    (is_held ? found.atropisomers : found.rotors).push_back(framework.label(Bar{rotor.a, rotor.b}));
  }
  for (const FlexibleRing& ring : moves.rings()) {
    const std::string forms = std::to_string(ring.forms.size());
    found.rings.push_back(ring_names(framework, ring.atoms) + " (" + forms + " forms)");
  }
  for (const std::vector<Joint>& ring : moves.rigid_rings())
    found.rigid_rings.push_back(ring_names(framework, ring));
  for (const Amine& amine : moves.amines()) found.amines.push_back(framework.label(amine.nitrogen));
  for (const AmideTurn& amide : moves.amides())
    found.amides.push_back(framework.label(Bar{amide.carbon, amide.nitrogen}));
  return found;
}

}  // namespace pliant::app
