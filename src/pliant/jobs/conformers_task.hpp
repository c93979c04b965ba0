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
#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/model/model.hpp"

namespace pliant {

struct ConformersAsked {
  std::int64_t frames = 500;  ///< conformers drawn, shared among the starts; from 1
  std::uint64_t seed = 0;
  bool turn_amides = false;  ///< secondary amides are cis or trans, too
  std::int64_t threads = 1;  ///< changes no result
  Log log = {};
};

struct DrawnConformers {
  std::vector<std::vector<Vec3>> positions;  ///< (F x N) Angstrom, by starts
  std::vector<std::uint32_t> start;          ///< (F)
  std::vector<double> energies;              ///< (F) kcal/mol, our own: ConformerEnergy
  double max_residual = 0.0;                 ///< worst bar: |length - rest| / rest
  std::string worst_bar;                     ///< its name; "" without bars
  std::int64_t failed = 0;                   ///< conformers that could not be made
};

/// Models of `count` starts, the first that of the structure. There are fewer where relaxing did
/// not keep the chirality or the double bonds of a conformer. Throws as build_model() does, and
/// OptionError for a count below 1.
std::vector<MolecularModel> conformer_starts(const Structure& structure, std::int64_t count,
                                             const ConformersAsked& asked);

/// Draws conformers of models of the same molecule, by sampler `torsions`. Of one start they are
/// those of sample(). Throws as sample() does.
DrawnConformers draw_conformers(std::span<const MolecularModel> starts,
                                const ConformersAsked& asked);

}  // namespace pliant
