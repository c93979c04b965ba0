// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/molecule_header.hpp"

#include "pliant/base/elements.hpp"
#include "pliant/base/version.hpp"

namespace pliant {

std::vector<RecordedBond> recorded_bonds(const Structure& structure) {
  std::vector<RecordedBond> bonds;
  bonds.reserve(structure.bonds.size());
  for (const Bond& bond : structure.bonds)
    bonds.push_back({bond.a, bond.b, static_cast<std::uint8_t>(bond.origin), bond.order});
  return bonds;
}

H5mdHeader molecule_header(const Structure& structure) {
  H5mdHeader header;
  header.bonds = recorded_bonds(structure);
  header.bond_origin_names.assign(bond_origin_names.begin(), bond_origin_names.end());
  if (structure.format != "graph")
    for (std::uint8_t element : structure.atoms.elements)
      header.masses.push_back(element_mass(element));
  header.creator_version = std::string(version());
  return header;
}

}  // namespace pliant
