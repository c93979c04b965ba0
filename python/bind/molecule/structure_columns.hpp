// SPDX-License-Identifier: MIT
// A Structure from columns: what the constructor of the Python class takes.
#pragma once

#include "arrays.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::python {

using Texts = std::optional<std::vector<std::string>>;

/// Makes `self` of columns of N atoms and M bonds. Throws InputError naming the column.
void make_structure(Structure* self, const ArrayLike& positions, const OptionalArray& elements,
                    const Texts& names, const Texts& residue_names,
                    const OptionalArray& residue_ids, const Texts& insertion_codes,
                    const Texts& chains, const OptionalArray& serials, const OptionalArray& bonds,
                    const OptionalArray& bond_orders, const std::string& title);

/// The bonds with a < b, sorted by (a, b), each pair once: of several orders the highest.
std::vector<Bond> canonical(std::vector<Bond> bonds);

}  // namespace pliant::python
