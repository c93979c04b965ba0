// SPDX-License-Identifier: MIT
// The task `conformers`: from a small molecule to conformers of several starts, with an energy to
// rank them by.
//
// Conformers of one start all have its bond lengths and angles, which costs accuracy. So more
// starts are made: conformers of the first, relaxed, their lengths, angles and rings as those
// conformers want them. Each conformer is exact in the bars of its own start.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/jobs/asked/conformer_options.hpp"
#include "pliant/model/model.hpp"

namespace pliant {

struct DrawnConformers {
  std::vector<std::vector<Vec3>> positions;  ///< (F x N) Angstrom, by starts
  std::vector<std::uint32_t> start;          ///< (F)
  std::vector<double> energies;              ///< (F) kcal/mol, our own: ConformerEnergy
  double max_residual = 0.0;                 ///< worst bar: |length - rest| / rest
};

/// Models of as many starts as asked for, the first that of the structure. There are fewer where
/// relaxing did not keep the chirality or the double bonds of a conformer. Throws as build_model()
/// and check() do.
std::vector<MolecularModel> conformer_starts(const Structure& structure,
                                             const ConformerOptions& asked);

/// Draws conformers of models of the same molecule, by sampler `torsions`. Of one start they are
/// those of sample(). Throws as sample() does.
DrawnConformers draw_conformers(std::span<const MolecularModel> starts,
                                const ConformerOptions& asked);

}  // namespace pliant
