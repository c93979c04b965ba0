// SPDX-License-Identifier: MIT
// The part of a trajectory that describes its molecule.
#pragma once

#include <vector>

#include "pliant/molecule/structure/structure.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"

namespace pliant {

std::vector<RecordedBond> recorded_bonds(const Structure& structure);

/// Bonds, masses (except for graphs, whose joints are no atoms) and the version; parameters are
/// empty.
H5mdHeader molecule_header(const Structure& structure);

}  // namespace pliant
