// SPDX-License-Identifier: MIT
#include "pliant/molecule/structure/atom_lookup.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace pliant {
namespace {

auto key(const Residue& residue) {
  return std::make_tuple(std::string_view(residue.chain), residue.number, residue.insertion_code);
}

}  // namespace

AtomLookup::AtomLookup(const AtomTable& atoms)
    : atoms_(atoms), first_atom_(atoms.residues.size() + 1), by_address_(atoms.residues.size()) {
  for (std::uint32_t residue : atoms.residue_of) ++first_atom_[residue + 1];
  std::partial_sum(first_atom_.begin(), first_atom_.end(), first_atom_.begin());
  std::iota(by_address_.begin(), by_address_.end(), std::uint32_t{0});
  std::sort(by_address_.begin(), by_address_.end(), [&](std::uint32_t p, std::uint32_t q) {
    return std::make_pair(key(atoms.residues[p]), p) < std::make_pair(key(atoms.residues[q]), q);
  });
}

std::optional<std::uint32_t> AtomLookup::find(const AtomAddress& address) const {
  const auto wanted = std::make_tuple(address.chain, address.number, address.insertion_code);
  auto residue =
      std::lower_bound(by_address_.begin(), by_address_.end(), wanted,
                       [&](std::uint32_t r, const auto& w) { return key(atoms_.residues[r]) < w; });
  std::optional<std::uint32_t> found;
  for (; residue != by_address_.end() && key(atoms_.residues[*residue]) == wanted; ++residue) {
    for (std::uint32_t i = first_atom_[*residue]; i < first_atom_[*residue + 1]; ++i) {
      if (atoms_.names[i] != address.name) continue;
      if (found) return std::nullopt;
      found = i;
    }
  }
  return found;
}

}  // namespace pliant
