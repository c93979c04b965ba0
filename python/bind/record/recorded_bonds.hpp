// SPDX-License-Identifier: MIT
// The parts of a structure that recorders write.
#pragma once

#include <vector>

#include "pliant/base/elements.hpp"
#include "pliant/base/version.hpp"
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

/// Bonds, masses and the version; `structure` may be null.
inline H5mdHeader header_of(const Structure* structure) {
  H5mdHeader header;
  header.creator_version = version();
  if (structure == nullptr) return header;
  header.bonds = recorded_bonds(*structure);
  header.bond_origin_names.assign(bond_origin_names.begin(), bond_origin_names.end());
  for (std::uint8_t element : structure->atoms.elements)
    header.masses.push_back(element_mass(element));
  return header;
}

}  // namespace pliant::python
