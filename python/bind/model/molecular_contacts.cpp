// SPDX-License-Identifier: MIT
#include "model/molecular_contacts.hpp"

#include <array>
#include <string>

#include "pliant/base/choices.hpp"

namespace pliant::python {
namespace {

struct RealField {
  const char* name;
  double MolecularContact::*place;
};
constexpr std::array<RealField, 7> real_fields{{{"energy", &MolecularContact::energy},
                                                {"distance", &MolecularContact::distance},
                                                {"least", &MolecularContact::least},
                                                {"most", &MolecularContact::most},
                                                {"hydrogen_most", &MolecularContact::hydrogen_most},
                                                {"base_least", &MolecularContact::base_least},
                                                {"base_most", &MolecularContact::base_most}}};

struct AtomField {
  const char* name;
  std::uint32_t MolecularContact::*place;
};
constexpr std::array<AtomField, 4> atom_fields{{{"a", &MolecularContact::a},
                                                {"b", &MolecularContact::b},
                                                {"hydrogen", &MolecularContact::hydrogen},
                                                {"base", &MolecularContact::base}}};

nb::list dtype_of_contacts() {
  nb::list fields;
  fields.append(nb::make_tuple("kind", "U16"));
  for (const AtomField& field : atom_fields) fields.append(nb::make_tuple(field.name, "i8"));
  for (const RealField& field : real_fields) fields.append(nb::make_tuple(field.name, "f8"));
  return fields;
}

std::int64_t index_to_python(std::uint32_t atom) {
  return atom == MolecularContact::none ? -1 : std::int64_t{atom};
}

/// A field of a row of an array.
template <class Value>
Value field_of(nb::handle row, const char* name, std::size_t index) {
  try {
    return nb::cast<Value>(row[name].attr("item")());
  } catch (const std::exception&) {
    throw nb::type_error(("contacts[" + std::to_string(index) +
                          "]: expected a row of the array that contacts() gives, with field " +
                          name)
                             .c_str());
  }
}

}  // namespace

nb::object contacts_to_python(const std::vector<MolecularContact>& contacts) {
  nb::list rows;
  for (const MolecularContact& contact : contacts) {
    nb::list row;
    row.append(std::string(name(contact.kind)));
    for (const AtomField& field : atom_fields) row.append(index_to_python(contact.*field.place));
    for (const RealField& field : real_fields) row.append(contact.*field.place);
    rows.append(nb::tuple(row));
  }
  return nb::module_::import_("numpy").attr("array")(rows, "dtype"_a = dtype_of_contacts());
}

std::vector<MolecularContact> contacts_from(nb::handle rows) {
  std::vector<MolecularContact> contacts;
  for (nb::handle row : rows) {
    const std::size_t index = contacts.size();
    MolecularContact contact;
    contact.kind = choose(molecular_contact_kinds(), "kind of contact",
                          field_of<std::string>(row, "kind", index))
                       .kind;
    for (const AtomField& field : atom_fields)
      contact.*field.place =
          static_cast<std::uint32_t>(field_of<std::int64_t>(row, field.name, index));
    for (const RealField& field : real_fields)
      contact.*field.place = field_of<double>(row, field.name, index);
    contacts.push_back(contact);
  }
  return contacts;
}

}  // namespace pliant::python
