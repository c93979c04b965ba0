// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/additives.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "pliant/base/choices.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/graphs/disjoint_sets.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/model/atoms/near_atoms.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/molecule/crystal_additives.hpp"

namespace pliant {
namespace {

constexpr double metal_bond = 2.8;  // Angstrom, at most, of N, O and S
constexpr std::string_view all_of_them = "all";

bool has(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

void check_names(const std::vector<std::string>& keep,
                 const std::vector<std::string_view>& additives) {
  for (const std::string& name : keep) {
    if (name == all_of_them || std::ranges::find(additives, name) != additives.end()) continue;
    const std::string near = nearest_name(name, additives);
    throw OptionError("keep: expected all or names of additives such as GOL or SO4, found " +
                      quoted(name) + (near.empty() ? "" : " (did you mean " + near + "?)"));
  }
}

bool has_polymer(const Structure& structure) {
  return std::ranges::any_of(structure.atoms.residues, [](const Residue& residue) {
    return is_amino_acid(residue) || is_nucleotide(residue);
  });
}

/// (R) by name alone.
std::vector<bool> named_additives(const AtomTable& atoms, const std::vector<std::string>& keep,
                                  const std::vector<std::string_view>& additives) {
  std::vector<bool> is_one;
  for (const Residue& residue : atoms.residues)
    is_one.push_back(std::ranges::find(additives, residue.name) != additives.end() &&
                     !has(keep, residue.name));
  return is_one;
}

/// None is bonded to what is not one, directly or over others.
void keep_bonded(const Structure& structure, std::vector<bool>& is_one) {
  const auto& residue_of = structure.atoms.residue_of;
  DisjointSets sets;
  sets.reset(is_one.size());
  for (const Bond& bond : structure.bonds) sets.unite(residue_of[bond.a], residue_of[bond.b]);
  std::vector<bool> is_kept(is_one.size());
  for (std::uint32_t r = 0; r < is_one.size(); ++r)
    if (!is_one[r]) is_kept[sets.find(r)] = true;
  for (std::uint32_t r = 0; r < is_one.size(); ++r)
    if (is_kept[sets.find(r)]) is_one[r] = false;
}

/// (R) which of them hold a metal.
std::vector<bool> at_metals(const Structure& structure, const std::vector<bool>& is_one) {
  std::vector<std::uint32_t> metals, holders;
  for (std::uint32_t i = 0; i < structure.size(); ++i) {
    const std::uint8_t element = structure.atoms.elements[i];
    if (is_metal(element)) metals.push_back(i);
    if (is_one[structure.atoms.residue_of[i]] && (element == 7 || element == 8 || element == 16))
      holders.push_back(i);
  }
  std::vector<bool> found(is_one.size());
  const auto near = near_atoms(structure, metals, holders, metal_bond);
  for (std::size_t k = 0; k < metals.size(); ++k)
    for (std::uint32_t atom : near.at(k)) found[structure.atoms.residue_of[atom]] = true;
  return found;
}

}  // namespace

Additives find_additives(const Structure& structure, const std::vector<std::string>& keep) {
  const std::vector<std::string_view> additives = crystal_additive_names();
  check_names(keep, additives);
  if (has(keep, all_of_them) || !has_polymer(structure)) return {};
  std::vector<bool> is_one = named_additives(structure.atoms, keep, additives);
  if (std::ranges::find(is_one, true) == is_one.end()) return {};
  keep_bonded(structure, is_one);
  const std::vector<bool> is_at_metal = at_metals(structure, is_one);
  Additives found;
  for (std::uint32_t r = 0; r < is_one.size(); ++r)
    if (is_one[r]) (is_at_metal[r] ? found.at_metals : found.out).push_back(r);
  return found;
}

std::string counted_names(const AtomTable& atoms, const std::vector<std::uint32_t>& residues) {
  std::map<std::string_view, std::size_t> counts;
  for (std::uint32_t r : residues) ++counts[atoms.residues[r].name];
  std::vector<std::pair<std::string_view, std::size_t>> rows(counts.begin(), counts.end());
  std::ranges::stable_sort(rows, [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for (const auto& [name, count] : rows)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(name);
  return text;
}

}  // namespace pliant
