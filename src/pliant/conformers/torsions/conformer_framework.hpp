// SPDX-License-Identifier: MIT
// The framework for conformers of small molecules: amides that turn have no bar across them, and
// puckered rings have limits at their angles. Both are still rigid units while a conformer is
// resolved.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pliant/conformers/rings/bond_chemistry.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"

namespace pliant {

/// What of a molecule may change besides torsions, simple rings and amines.
struct ConformerMoves {
  /// Amides, ureas and carbamates (and their thio analogues) with hydrogen at N turn from cis to
  /// trans. Those without, tertiary ones, always do.
  bool secondary_amides = false;
  /// Rings that share bonds take other forms (system_forms.hpp), which takes time to find.
  bool ring_systems = true;
  /// Axes of atropisomers (BondTurn::atropisomer) take both hands.
  bool both_hands = false;
};

/// An amide outside of rings, either cis or trans.
struct Amide {
  Joint carbon, nitrogen;
};

/// The amides of a molecule that turn (bond in no ring), by carbon, then nitrogen.
std::vector<Amide> turning_amides(const Framework& framework, const BondChemistry& chemistry,
                                  ConformerMoves moves);

/// `framework` without the bars across its `amides` (1-4), which a turn from cis to trans
/// would break, and across the single bonds of amidines and amides of rings of nine and more, about
/// which rotors and loops turn. Angles at the atoms of puckered rings of five and six become
/// limits, 0.12 Angstrom to both sides, since they change by some degrees from form to form. Heavy
/// atoms four bonds apart may come as near as 0.9 of their least distance, since angles that cannot
/// open bring them together; no heavy atoms four bonds and more apart come nearer than 2.68
/// Angstrom (overlaps of 0.08 are let be), unless they are nearer at `start` (N, Angstrom).
Framework conformer_framework(const Framework& framework, std::span<const Vec3> start,
                              ConformerMoves moves = {});

/// The plan of bodies for resolving conformers, in which amides that turn and rings are rigid even
/// without bars that hold them. Nothing if BodyPlan::make gives none.
std::optional<BodyPlan> conformer_plan(const Framework& framework, std::span<const Vec3> start,
                                       ConformerMoves moves = {});

/// The same, but amides of rings of nine and more turn, for drawing loops; nothing if there are
/// none.
std::optional<BodyPlan> drawing_plan(const Framework& framework, std::span<const Vec3> start,
                                     ConformerMoves moves = {});

}  // namespace pliant
