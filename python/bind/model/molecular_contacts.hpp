// SPDX-License-Identifier: MIT
// Contacts of molecules as arguments and results: numpy arrays with named fields.
#pragma once

#include <vector>

#include "bind.hpp"
#include "pliant/model/contacts/contact_list.hpp"

namespace pliant::python {

/// Returns a numpy array with the fields of a contact; -1 for no hydrogen or base.
nb::object contacts_to_python(const std::vector<MolecularContact>& contacts);

/// Reads contacts from an array of contacts_to_python, or from part of it. Throws TypeError without
/// these fields, OptionError for an unknown kind.
std::vector<MolecularContact> contacts_from(nb::handle rows);

}  // namespace pliant::python
