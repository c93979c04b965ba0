// SPDX-License-Identifier: MIT
// Bonds of a structure as recorders take them.
#pragma once

#include <vector>

#include "pliant/molecule/structure/structure.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"

namespace pliant::python {

inline std::vector<RecordedBond> recorded_bonds(const Structure& structure) {
  std::vector<RecordedBond> bonds;
  bonds.reserve(structure.bonds.size());
  for (const Bond& bond : structure.bonds)
    bonds.push_back({bond.a, bond.b, static_cast<std::uint8_t>(bond.origin), bond.order});
  return bonds;
}

}  // namespace pliant::python
