// SPDX-License-Identifier: MIT
#include "pliant/framework/atom_table.hpp"

#include <string_view>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

/// Names come from files, labels go to terminals.
std::string ascii(std::string_view text) {
  std::string in_quotes = quoted(text);
  return in_quotes.substr(1, in_quotes.size() - 2);
}

void check_column(std::string_view name, std::size_t size, std::size_t atoms) {
  if (size == atoms) return;
  throw InputError("atom table: " + std::to_string(atoms) + " names but " + std::to_string(size) +
                   " " + std::string(name));
}

}  // namespace

std::string AtomTable::label(std::size_t atom) const {
  const Residue& residue = residues[residue_of[atom]];
  if (residues.size() == 1 && residue.name.empty()) return ascii(names[atom]);
  if (residues.size() == 1) return ascii(names[atom]) + "(" + std::to_string(serials[atom]) + ")";
  std::string text = residue.chain.empty() ? "" : ascii(residue.chain) + ":";
  text += ascii(residue.name) + std::to_string(residue.number);
  if (residue.insertion_code != ' ') text += ascii({&residue.insertion_code, 1});
  return text + ":" + ascii(names[atom]);
}

void check(const AtomTable& atoms) {
  check_column("elements", atoms.elements.size(), atoms.size());
  check_column("residue indices", atoms.residue_of.size(), atoms.size());
  check_column("serials", atoms.serials.size(), atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    if (atoms.residue_of[i] < atoms.residues.size()) continue;
    throw InputError("atom table: atom " + std::to_string(i) + " is in residue " +
                     std::to_string(atoms.residue_of[i]) + " of " +
                     std::to_string(atoms.residues.size()));
  }
}

}  // namespace pliant
