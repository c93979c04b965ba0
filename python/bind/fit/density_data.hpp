// SPDX-License-Identifier: MIT
// A map and the mass of a molecule that is to explain it, for fits.
#pragma once

#include "bind.hpp"
#include "pliant/fit/map/density_term.hpp"

namespace pliant::python {

/// Throws InputError unless the mass is that of a molecule with so many nodes.
void check_sites(const DensityTarget& density, std::size_t nodes);

void bind_density_data(nb::module_& module);

}  // namespace pliant::python
