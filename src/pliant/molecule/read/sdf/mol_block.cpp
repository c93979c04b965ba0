// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/sdf/mol_block.hpp"

#include <algorithm>
#include <string>

#include "pliant/base/elements.hpp"
#include "pliant/molecule/read/shared/reading.hpp"

namespace pliant {

namespace {

/// Sets a value in a row that is empty until an atom has one.
template <class Value>
void set_value(std::vector<Value>& row, std::size_t atom, std::int64_t value) {
  if (value == 0 && row.empty()) return;
  row.resize(std::max(row.size(), atom + 1), 0);
  row[atom] = static_cast<Value>(value);
}

/// "D" and "T" are hydrogen by mass number.
std::int64_t isotope_of_symbol(std::string_view symbol) {
  return symbol == "D" ? 2 : symbol == "T" ? 3 : 0;
}

}  // namespace

void MolBlock::add_atom(std::string_view symbol, Vec3 position, std::int64_t serial,
                        std::size_t line) {
  const std::int64_t isotope = isotope_of_symbol(symbol);
  const std::uint8_t element = element_number(isotope == 0 ? symbol : "H");
  if (element == 0)
    remarks_.warn("unknown symbol", line, [&] {
      return "atom symbol " + quoted(symbol) + " is not an element: taken as unknown";
    });
  AtomTable& atoms = structure_.atoms;
  if (atoms.residues.empty()) atoms.residues.push_back({"UNK", 1, ' ', ""});
  atoms.names.emplace_back(symbol);
  atoms.elements.push_back(element);
  atoms.residue_of.push_back(0);
  atoms.serials.push_back(serial);
  structure_.positions.push_back(position);
  set_isotope(size() - 1, isotope, line);
}

void MolBlock::set_charge(std::size_t atom, std::int64_t charge, std::size_t line) {
  if (charge < -15 || charge > 15)
    fail(remarks_.place(line), "charge " + std::to_string(charge) + " is not from -15 to 15");
  set_value(structure_.charges, atom, charge);
}

void MolBlock::set_isotope(std::size_t atom, std::int64_t mass, std::size_t line) {
  constexpr std::int64_t most = 400;
  if (mass < 0 || mass > most)
    fail(remarks_.place(line), "isotope " + std::to_string(mass) + " is not from 0 to 400");
  set_value(structure_.isotopes, atom, mass);
}

void MolBlock::set_radical(std::size_t atom, std::int64_t multiplicity, std::size_t line) {
  if (multiplicity < 0 || multiplicity > 3)
    fail(remarks_.place(line), "radical " + std::to_string(multiplicity) + " is not from 0 to 3");
  set_value(structure_.radicals, atom, multiplicity);
}

void MolBlock::clear_charges_and_radicals() {
  structure_.charges.clear();
  structure_.radicals.clear();
}

void MolBlock::add_bond(std::size_t a, std::size_t b, std::int64_t type, std::size_t line) {
  constexpr std::int64_t hydrogen_bond = 10;
  if (type < 0 || type > hydrogen_bond)
    fail(remarks_.place(line), "bond type " + std::to_string(type) + " is not from 0 to 10");
  if (a == b)
    fail(remarks_.place(line),
         "a bond of atom " + std::to_string(structure_.atoms.serials[a]) + " to itself");
  if (type == hydrogen_bond) {
    ++left_out_;
    remarks_.warn("hydrogen bond", line,
                  [] { return "a bond of type 10 (hydrogen bond) is left out"; });
    return;
  }
  const auto order = static_cast<std::uint8_t>(type <= 4 ? type : 0);
  bonds_.push_back({{static_cast<std::uint32_t>(std::min(a, b)),
                     static_cast<std::uint32_t>(std::max(a, b)), BondOrigin::file, order},
                    line});
}

Structure MolBlock::take() {
  std::sort(bonds_.begin(), bonds_.end(), [](const LineBond& p, const LineBond& q) {
    if (p.bond.a != q.bond.a) return p.bond.a < q.bond.a;
    return p.bond.b != q.bond.b ? p.bond.b < q.bond.b : p.line < q.line;
  });
  for (std::size_t k = 0; k < bonds_.size(); ++k) {
    const Bond& bond = bonds_[k].bond;
    const bool repeats = k > 0 && bond.a == bonds_[k - 1].bond.a && bond.b == bonds_[k - 1].bond.b;
    if (!repeats) structure_.bonds.push_back(bond);
    if (repeats)
      remarks_.warn("repeated bond", bonds_[k].line, [&] {
        return "the bond of atoms " + std::to_string(structure_.atoms.serials[bond.a]) + " and " +
               std::to_string(structure_.atoms.serials[bond.b]) +
               " is given twice: the first is used";
      });
  }
  if (!structure_.charges.empty()) structure_.charges.resize(structure_.size(), 0);
  if (!structure_.isotopes.empty()) structure_.isotopes.resize(structure_.size(), 0);
  if (!structure_.radicals.empty()) structure_.radicals.resize(structure_.size(), 0);
  const auto& positions = structure_.positions;
  const bool flat =
      std::all_of(positions.begin(), positions.end(), [](Vec3 p) { return p.z == 0; });
  if (flat && positions.size() > 3)
    remarks_.warn("flat", 0, [] {
      return "all atoms have z = 0: if this is a 2-D drawing, make a 3-D structure first";
    });
  return std::move(structure_);
}

bool ends_record(std::string_view line) { return line.starts_with("$$$$"); }

std::string_view next_record_line(Lines& lines, std::string_view wanted, const Remarks& remarks) {
  const bool there = lines.next();
  if (!there || ends_record(lines.line()))
    fail(remarks.place(lines.number() + (there ? 0 : 1)),
         std::string(there ? "the record" : "the file") + " ends where " + std::string(wanted) +
             " is expected");
  return lines.line();
}

}  // namespace pliant
