// SPDX-License-Identifier: MIT
#include "pliant/sample/pocket/pocket.hpp"

#include <algorithm>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

/// (residues) whether it is one of a protein: has N, CA and C.
std::vector<bool> amino_acids(const AtomTable& atoms) {
  std::vector<int> found(atoms.residues.size(), 0);
  for (std::size_t k = 0; k < atoms.size(); ++k)
    if (atoms.names[k] == "N" || atoms.names[k] == "CA" || atoms.names[k] == "C")
      ++found[atoms.residue_of[k]];
  std::vector<bool> out;
  for (const int count : found) out.push_back(count >= 3);
  return out;
}

/// (residues) those with an atom near to one of `selected`.
std::vector<bool> near_residues(const AtomTable& atoms, std::span<const Vec3> start,
                                std::span<const Joint> selected) {
  constexpr std::uint8_t hydrogen = 1;
  std::vector<bool> is_near(atoms.residues.size(), false);
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    if (atoms.elements[k] == hydrogen || is_near[atoms.residue_of[k]]) continue;
    is_near[atoms.residue_of[k]] = std::ranges::any_of(selected, [&](Joint joint) {
      return atoms.elements[joint] != hydrogen &&
             distance(start[joint], start[k]) <= place_distance;
    });
  }
  return is_near;
}

std::vector<Joint> whole_residues(const AtomTable& atoms, std::span<const Joint> selected) {
  std::vector<bool> is_taken(atoms.residues.size(), false);
  for (const Joint joint : selected) is_taken[atoms.residue_of[joint]] = true;
  std::vector<Joint> out;
  for (Joint k = 0; k < atoms.size(); ++k)
    if (is_taken[atoms.residue_of[k]]) out.push_back(k);
  return out;
}

}  // namespace

Pocket pocket_around(const Framework& framework, std::span<const Vec3> start,
                     std::span<const Joint> selected) {
  Pocket place{{}, std::vector<bool>(framework.joint_count(), framework.atoms() == nullptr), {}};
  if (framework.atoms() == nullptr) return place;
  const AtomTable& atoms = *framework.atoms();
  const std::vector<bool> is_amino_acid = amino_acids(atoms);
  std::vector<bool> is_taken(atoms.residues.size(), selected.empty());
  for (const Joint joint : selected)
    if (is_amino_acid[atoms.residue_of[joint]]) is_taken[atoms.residue_of[joint]] = true;
  if (std::ranges::find(is_taken, true) == is_taken.end()) {
    place.ligand = whole_residues(atoms, selected);
    is_taken = near_residues(atoms, start, selected);
    for (std::size_t r = 0; r < is_taken.size(); ++r) is_taken[r] = is_taken[r] && is_amino_acid[r];
  }
  for (std::uint32_t r = 0; r < is_taken.size(); ++r)
    if (is_taken[r]) place.residues.push_back(r);
  if (place.residues.empty())
    throw OptionError("around: no residue of a protein is within 6 Angstrom of the atoms selected");
  for (std::size_t k = 0; k < atoms.size(); ++k) place.has_joint[k] = is_taken[atoms.residue_of[k]];
  return place;
}

std::vector<std::string> names_of(const Pocket& place, const Framework& framework) {
  std::vector<std::string> names;
  for (const std::uint32_t r : place.residues) {
    const Residue& at = framework.atoms()->residues[r];
    names.push_back((at.chain.empty() ? "" : at.chain + ":") + at.name + std::to_string(at.number));
    if (at.insertion_code != ' ') names.back() += at.insertion_code;
  }
  return names;
}

}  // namespace pliant
