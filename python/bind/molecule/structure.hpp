// SPDX-License-Identifier: MIT
// The class Structure: its columns as arrays, and its construction from arrays.
#pragma once

#include "bind.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::python {

nb::class_<Structure> bind_structure(nb::module_& module);

/// The Structure that an argument is; of a path, or a molecule of another package, one that is made
/// (`structure_of` of pliant.trajectory.sources). Throws what that raises.
nb::object structure_from(nb::handle argument);

/// What `structure_from` takes, as signatures have it.
inline constexpr const char* any_molecule = "Structure | Molecule";

}  // namespace pliant::python
