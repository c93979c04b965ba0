// SPDX-License-Identifier: MIT
// Molecules in density maps: atoms by their weights, and what DensityMap says of them.
#pragma once

#include <cstdint>
#include <vector>

#include "bind.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/fit/map/density_map.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::python {

/// Atoms of a known element, by their atomic numbers.
struct WeighedAtoms {
  std::vector<Vec3> positions;
  std::vector<double> weights;
  std::vector<std::uint32_t> residue_of;
};

/// Throws InputError if there are none.
WeighedAtoms weighed_atoms(const Structure& structure);
/// The same of what structure_from() takes.
WeighedAtoms weighed_atoms(const nb::handle& structure);

/// Adds the methods that compare a molecule with a map, or put it there.
void bind_map_agreement(nb::class_<DensityMap>& bound);

}  // namespace pliant::python
