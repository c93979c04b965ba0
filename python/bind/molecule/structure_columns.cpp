// SPDX-License-Identifier: MIT
#include "molecule/structure_columns.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"

namespace pliant::python {
namespace {

template <class Column>
void check_length(const char* name, const Column& column, std::size_t count, const char* what) {
  if (column.size() != count)
    throw InputError(std::string(name) + ": " + std::to_string(column.size()) + " for " +
                     std::to_string(count) + " " + what);
}

std::uint8_t element_from_number(std::int64_t number, std::size_t atom) {
  if (number < 0 || number > element_count)
    throw InputError("elements[" + std::to_string(atom) +
                     "]: expected an atomic number from 0 to " + std::to_string(element_count) +
                     ", found " + std::to_string(number));
  return static_cast<std::uint8_t>(number);
}

std::uint8_t element_from_symbol(const std::string& symbol, std::size_t atom) {
  const std::uint8_t number = element_number(symbol);
  if (number == 0 && !symbol.empty() && symbol != "X")
    throw InputError("elements[" + std::to_string(atom) + "]: " + pliant::quoted(symbol) +
                     " is no element");
  return number;
}

/// Symbols or atomic numbers, whichever the column holds.
std::vector<std::uint8_t> elements_from(const ArrayLike& column) {
  std::vector<std::uint8_t> elements;
  std::vector<std::string> symbols;
  if (nb::try_cast(column.object, symbols)) {
    for (const std::string& symbol : symbols)
      elements.push_back(element_from_symbol(symbol, elements.size()));
  } else {
    for (std::int64_t number : integers_from(column, "elements"))
      elements.push_back(element_from_number(number, elements.size()));
  }
  return elements;
}

std::vector<std::string> symbols_of(const std::vector<std::uint8_t>& elements) {
  std::vector<std::string> symbols;
  for (std::uint8_t element : elements) symbols.emplace_back(element_symbol(element));
  return symbols;
}

/// The columns that tell residues apart; a missing one says nothing.
struct ResidueColumns {
  TextColumn names;
  std::optional<std::vector<std::int64_t>> ids;
  TextColumn insertion_codes;
  TextColumn chains;

  void check(std::size_t count) const {
    if (names) check_length("residue_names", *names, count, "atoms");
    if (ids) check_length("residue_ids", *ids, count, "atoms");
    if (insertion_codes) check_length("insertion_codes", *insertion_codes, count, "atoms");
    if (chains) check_length("chains", *chains, count, "atoms");
  }

  char insertion_code(std::size_t atom) const {
    if (!insertion_codes) return ' ';
    const std::string& code = (*insertion_codes)[atom];
    if (code.size() > 1)
      throw InputError("insertion_codes[" + std::to_string(atom) +
                       "]: expected one character or none, found " + pliant::quoted(code));
    return code.empty() ? ' ' : code[0];
  }

  Residue of(std::size_t atom) const {
    return {names ? (*names)[atom] : "UNK", ids ? (*ids)[atom] : 1, insertion_code(atom),
            chains ? (*chains)[atom] : ""};
  }
};

void take_residues(AtomTable& atoms, const ResidueColumns& columns, std::size_t count) {
  columns.check(count);
  for (std::size_t i = 0; i < count; ++i) {
    Residue residue = columns.of(i);
    if (i == 0 || !(residue == atoms.residues.back())) atoms.residues.push_back(std::move(residue));
    atoms.residue_of.push_back(static_cast<std::uint32_t>(atoms.residues.size() - 1));
  }
}

std::uint8_t order_from(std::int64_t order, std::size_t bond) {
  if (order < 0 || order > 4)
    throw InputError("bond_orders[" + std::to_string(bond) + "]: expected 0 to 4, found " +
                     std::to_string(order));
  return static_cast<std::uint8_t>(order);
}

std::vector<Bond> bonds_from(const ArrayLike& pairs, const OptionalArray& orders,
                             std::size_t atom_count) {
  std::vector<Bond> bonds;
  for (const Bar& pair : pairs_from(pairs, "bonds", atom_count)) {
    if (pair.a == pair.b)
      throw InputError("bonds[" + std::to_string(bonds.size()) + "] joins atom " +
                       std::to_string(pair.a) + " to itself");
    bonds.push_back({pair.a, pair.b, BondOrigin::file, 0});
  }
  if (!orders) return bonds;
  const std::vector<std::int64_t> values = integers_from(*orders, "bond_orders");
  check_length("bond_orders", values, bonds.size(), "bonds");
  for (std::size_t k = 0; k < bonds.size(); ++k) bonds[k].order = order_from(values[k], k);
  return bonds;
}

/// Empty where all are 0, as readers have it.
std::vector<std::int8_t> charges_from(const ArrayLike& column, std::size_t count) {
  constexpr std::int64_t most = 127;
  const std::vector<std::int64_t> values = integers_from(column, "charges");
  check_length("charges", values, count, "atoms");
  for (std::size_t i = 0; i < count; ++i)
    if (values[i] < -most || values[i] > most)
      throw InputError("charges[" + std::to_string(i) + "]: expected -127 to 127, found " +
                       std::to_string(values[i]));
  if (std::all_of(values.begin(), values.end(), [](std::int64_t q) { return q == 0; })) return {};
  return {values.begin(), values.end()};
}

void check_finite(const std::vector<Vec3>& positions) {
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!is_finite(positions[i]))
      throw InputError("positions[" + std::to_string(i) + "] is not finite");
}

std::vector<std::int64_t> one_to(std::size_t count) {
  std::vector<std::int64_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

}  // namespace

std::vector<Bond> canonical(std::vector<Bond> bonds) {
  for (Bond& bond : bonds)
    if (bond.a > bond.b) std::swap(bond.a, bond.b);
  const auto key = [](const Bond& bond) { return std::tuple(bond.a, bond.b, -int(bond.order)); };
  std::sort(bonds.begin(), bonds.end(),
            [&](const Bond& a, const Bond& b) { return key(a) < key(b); });
  const auto same = [](const Bond& a, const Bond& b) { return a.a == b.a && a.b == b.b; };
  bonds.erase(std::unique(bonds.begin(), bonds.end(), same), bonds.end());
  return bonds;
}

void make_structure(Structure* self, const ArrayLike& positions, const OptionalArray& elements,
                    const TextColumn& names, const TextColumn& residue_names,
                    const OptionalArray& residue_ids, const TextColumn& insertion_codes,
                    const TextColumn& chains, const OptionalArray& serials,
                    const OptionalArray& bonds, const OptionalArray& bond_orders,
                    const OptionalArray& charges, const std::string& title) {
  Structure made;
  made.title = title;
  made.positions = positions_from(positions);
  check_finite(made.positions);
  const std::size_t count = made.size();
  made.atoms.elements = elements ? elements_from(*elements) : std::vector<std::uint8_t>(count, 0);
  check_length("elements", made.atoms.elements, count, "atoms");
  made.atoms.names = names ? *names : symbols_of(made.atoms.elements);
  check_length("names", made.atoms.names, count, "atoms");
  made.atoms.serials = serials ? integers_from(*serials, "serials") : one_to(count);
  check_length("serials", made.atoms.serials, count, "atoms");
  ResidueColumns columns{residue_names, std::nullopt, insertion_codes, chains};
  if (residue_ids) columns.ids = integers_from(*residue_ids, "residue_ids");
  take_residues(made.atoms, columns, count);
  if (bonds) made.bonds = canonical(bonds_from(*bonds, bond_orders, count));
  if (charges) made.charges = charges_from(*charges, count);
  new (self) Structure(std::move(made));
}

}  // namespace pliant::python
