// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/select_part.hpp"

#include <string>

#include "pliant/base/error.hpp"
#include "pliant/model/prepare/edit_structure.hpp"
#include "pliant/molecule/selection.hpp"

namespace pliant {
namespace {

std::size_t bonds_across(const Structure& structure, const std::vector<bool>& is_out) {
  std::size_t count = 0;
  for (const Bond& bond : structure.bonds) count += is_out[bond.a] != is_out[bond.b] ? 1 : 0;
  return count;
}

void warn_of_cut_bonds(std::size_t cut, const Log& log) {
  if (cut == 0) return;
  log.warn("select: " + std::to_string(cut) +
           (cut == 1 ? " bond to an atom that is left out vanishes"
                     : " bonds to atoms that are left out vanish"));
}

}  // namespace

Structure select_part(const Structure& structure, std::string_view selection, const Log& log) {
  const std::vector<std::uint32_t> taken = select_some_atoms(structure.atoms, selection, "select");
  std::vector<bool> is_out(structure.size(), true);
  for (std::uint32_t atom : taken) is_out[atom] = false;
  log.note("select: " + std::to_string(taken.size()) + " of " + std::to_string(structure.size()) +
           " atoms");
  warn_of_cut_bonds(bonds_across(structure, is_out), log);
  return without_atoms(structure, is_out).structure;
}

}  // namespace pliant
