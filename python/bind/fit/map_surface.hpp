// SPDX-License-Identifier: MIT
// Surfaces of density maps.
#pragma once

#include "bind.hpp"
#include "pliant/fit/map/density_map.hpp"

namespace pliant::python {

void bind_map_surface(nb::class_<DensityMap>& bound);

}  // namespace pliant::python
