// SPDX-License-Identifier: MIT
// Contacts of molecules at the border: rows with names, as numpy has them.
#pragma once

#include <vector>

#include "bind.hpp"
#include "pliant/model/contacts/contact_list.hpp"

namespace pliant::python {

/// A numpy array with a field for each of a contact's; -1 for no hydrogen or base.
nb::object contacts_to_python(const std::vector<MolecularContact>& contacts);

/// Contacts of an array that contacts_to_python gives, or of part of it. Throws TypeError for what
/// has no such fields; OptionError for an unknown kind.
std::vector<MolecularContact> contacts_from(nb::handle rows);

}  // namespace pliant::python
