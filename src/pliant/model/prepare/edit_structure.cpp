// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/edit_structure.hpp"

#include <algorithm>
#include <numeric>

#include "pliant/base/graphs/grouped.hpp"

namespace pliant {
namespace {

/// Copies what belongs to the structure as a whole.
Structure heading_of(const Structure& from) {
  Structure to;
  to.title = from.title;
  to.source = from.source;
  to.format = from.format;
  to.model = from.model;
  to.model_count = from.model_count;
  to.assemblies = from.assemblies;
  to.cell = from.cell;
  to.dimensions = from.dimensions;
  to.b_factor_source = from.b_factor_source;
  to.b_factor_record = from.b_factor_record;
  return to;
}

/// Fills a structure atom by atom out of another.
class Copier {
 public:
  explicit Copier(const Structure& from)
      : from_(from), to_{heading_of(from), {}}, now_(from.size(), no_atom) {}

  void start_residue(std::size_t residue) {
    to_.structure.atoms.residues.push_back(from_.atoms.residues[residue]);
    if (!from_.chain_end.empty()) to_.structure.chain_end.push_back(from_.chain_end[residue]);
  }

  /// Into the residue started last.
  void copy(std::uint32_t atom) {
    now_[atom] = place(from_.atoms.names[atom], from_.atoms.elements[atom], from_.positions[atom]);
    to_.origin.push_back(atom);
    to_.structure.atoms.serials.push_back(from_.atoms.serials[atom]);
    if (!from_.charges.empty()) to_.structure.charges.push_back(from_.charges[atom]);
    if (!from_.isotopes.empty()) to_.structure.isotopes.push_back(from_.isotopes[atom]);
    if (!from_.radicals.empty()) to_.structure.radicals.push_back(from_.radicals[atom]);
    if (!from_.b_factors.empty()) to_.structure.b_factors.push_back(from_.b_factors[atom]);
  }

  void add(const NewAtom& atom) {
    const std::uint32_t parent = now_[atom.parent];
    const std::uint32_t self = place(atom.name, atom.element, atom.position);
    to_.origin.push_back(no_atom);
    to_.structure.atoms.serials.push_back(0);
    if (!from_.charges.empty()) to_.structure.charges.push_back(0);
    if (!from_.isotopes.empty()) to_.structure.isotopes.push_back(0);
    if (!from_.radicals.empty()) to_.structure.radicals.push_back(0);
    if (!from_.b_factors.empty()) to_.structure.b_factors.push_back(from_.b_factors[atom.parent]);
    if (atom.is_bonded) to_.structure.bonds.push_back({parent, self, BondOrigin::residue, 1});
  }

  /// A residue whose atoms all went has none to end a chain: the one before it does.
  void end_chain_before() {
    auto& ends = to_.structure.chain_end;
    if (!ends.empty()) ends.back() = true;
  }

  EditedStructure finish() {
    for (const Bond& bond : from_.bonds)
      if (now_[bond.a] != no_atom && now_[bond.b] != no_atom)
        to_.structure.bonds.push_back({std::min(now_[bond.a], now_[bond.b]),
                                       std::max(now_[bond.a], now_[bond.b]), bond.origin,
                                       bond.order});
    std::sort(to_.structure.bonds.begin(), to_.structure.bonds.end(),
              [](const Bond& one, const Bond& other) {
                return std::pair(one.a, one.b) < std::pair(other.a, other.b);
              });
    return std::move(to_);
  }

 private:
  std::uint32_t place(const std::string& name, std::uint8_t element, Vec3 position) {
    AtomTable& atoms = to_.structure.atoms;
    atoms.names.push_back(name);
    atoms.elements.push_back(element);
    atoms.residue_of.push_back(static_cast<std::uint32_t>(atoms.residues.size() - 1));
    to_.structure.positions.push_back(position);
    return static_cast<std::uint32_t>(atoms.names.size() - 1);
  }

  const Structure& from_;
  EditedStructure to_;
  std::vector<std::uint32_t> now_;  ///< (N of from_) where each atom is now
};

}  // namespace

EditedStructure without_atoms(const Structure& structure, const std::vector<bool>& is_out) {
  Copier copier(structure);
  const ResidueAtoms residues(structure.atoms);
  for (std::size_t r = 0; r < structure.atoms.residues.size(); ++r) {
    bool is_started = false;
    for (std::uint32_t atom = residues.begin(r); atom < residues.end(r); ++atom) {
      if (is_out[atom]) continue;
      if (!is_started) copier.start_residue(r);
      is_started = true;
      copier.copy(atom);
    }
    if (!is_started && !structure.chain_end.empty() && structure.chain_end[r])
      copier.end_chain_before();
  }
  return copier.finish();
}

EditedStructure with_atoms(const Structure& structure, const std::vector<NewAtom>& added) {
  Copier copier(structure);
  const ResidueAtoms residues(structure.atoms);
  const Grouped<std::uint32_t> of_residue(structure.atoms.residues.size(), [&](const auto& put) {
    for (std::uint32_t k = 0; k < added.size(); ++k)
      put(structure.atoms.residue_of[added[k].parent], k);
  });
  for (std::size_t r = 0; r < structure.atoms.residues.size(); ++r) {
    copier.start_residue(r);
    for (std::uint32_t atom = residues.begin(r); atom < residues.end(r); ++atom) copier.copy(atom);
    for (std::uint32_t k : of_residue.at(r)) copier.add(added[k]);
  }
  EditedStructure edited = copier.finish();
  if (!added.empty()) {
    auto& serials = edited.structure.atoms.serials;
    std::iota(serials.begin(), serials.end(), std::int64_t{1});
  }
  return edited;
}

}  // namespace pliant
