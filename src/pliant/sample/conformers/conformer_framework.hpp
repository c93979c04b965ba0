// SPDX-License-Identifier: MIT
// What conformers of small molecules are held by: amides that turn have no bar across them in the
// framework, rings that pucker have limits at their angles, and both still are rigid units while a
// conformer is resolved.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/resolve/froda/bodies/body_plan.hpp"
#include "pliant/sample/rings/bond_chemistry.hpp"

namespace pliant {

/// A tertiary amide outside of rings, which is cis or trans.
struct Amide {
  Joint carbon, nitrogen;
};

/// The tertiary amides of a molecule (N without hydrogen, bond in no ring), by carbon, then
/// nitrogen.
std::vector<Amide> tertiary_amides(const Framework& framework, const BondChemistry& chemistry);

/// The framework without the bars that reach across its tertiary amides (1-4), which a turn from
/// cis to trans would break. Angles at the atoms of puckered rings of five and six are limits in
/// place of bars, 0.12 Angstrom to both sides: a ring changes them by some degrees from form to
/// form. Heavy atoms four bonds apart may come as near as 0.9 of their least
/// distance (but 2.6 Angstrom), since angles that cannot open bring them together. `start` (N,
/// Angstrom).
Framework conformer_framework(const Framework& framework, std::span<const Vec3> start);

/// The plan of bodies in which conformers are resolved: tertiary amides and rings are rigid,
/// whether bars hold them or not. Null where BodyPlan::make gives none.
std::optional<BodyPlan> conformer_plan(const Framework& framework, std::span<const Vec3> start);

}  // namespace pliant
