// SPDX-License-Identifier: MIT
#include "pliant/framework/atom_table.hpp"

namespace pliant {

std::string AtomTable::label(std::size_t atom) const {
  const Residue& residue = residues[residue_of[atom]];
  if (residues.size() == 1) return names[atom] + "(" + std::to_string(serials[atom]) + ")";
  std::string text = residue.chain.empty() ? "" : residue.chain + ":";
  text += residue.name + std::to_string(residue.number);
  if (residue.insertion_code != ' ') text += residue.insertion_code;
  return text + ":" + names[atom];
}

}  // namespace pliant
