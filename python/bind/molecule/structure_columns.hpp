// SPDX-License-Identifier: MIT
// Makes a Structure from columns, for the constructor of the Python class.
#pragma once

#include "arrays.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::python {

using TextColumn = std::optional<std::vector<std::string>>;

/// Makes `self` from columns of N atoms and M bonds. Throws InputError naming the column.
void make_structure(Structure* self, const ArrayLike& positions, const OptionalArray& elements,
                    const TextColumn& names, const TextColumn& residue_names,
                    const OptionalArray& residue_ids, const TextColumn& insertion_codes,
                    const TextColumn& chains, const OptionalArray& serials,
                    const OptionalArray& bonds, const OptionalArray& bond_orders,
                    const OptionalArray& charges, const std::string& title);

/// Bonds with a < b, sorted by (a, b), each pair once with its highest order.
std::vector<Bond> canonical(std::vector<Bond> bonds);

}  // namespace pliant::python
