// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/side_chains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/model/atoms/near_atoms.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/side_chain.hpp"
#include "pliant/model/prepare/side_chain_geometry.hpp"

namespace pliant {
namespace {

/// Angstrom, from CA to the last atom of ARG, and to a contact beyond it.
constexpr double reach_of_atoms = 11.0, reach_of_side_chains = 19.0;

/// Nearer than this two atoms overlap, Angstrom (see steric_table.hpp; hydrogen: with any).
double least_distance(std::uint8_t one, std::uint8_t other) {
  const auto is_polar = [](std::uint8_t element) { return element == 7 || element == 8; };
  if (one == 1 || other == 1) return 2.3;
  return is_polar(one) && is_polar(other) ? 2.7 : 3.2;
}

// Angstrom^2: what a ring that does not close costs, beside squared overlaps.
constexpr double cost_of_strain = 100.0;

/// What was chosen for a side chain.
struct Choice {
  SideChain side_chain;
  std::vector<PlacedAtom> atoms = {};
  double overlap = 0.0;
};

/// Chooses torsions of all side chains that are not complete.
class Builder {
 public:
  explicit Builder(const Structure& structure) : structure_(structure), residues_(structure.atoms) {
    for (std::uint32_t r = 0; r < structure.atoms.residues.size(); ++r)
      if (const Residue& residue = structure.atoms.residues[r];
          is_amino_acid(residue) && !side_chain_atoms(standard_name(residue.name)).empty())
        look_at(r);
  }

  BuiltSideChains build() {
    find_surroundings();
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t k = 0; k < choices_.size(); ++k) choose(k);
    std::vector<NewAtom> added;
    for (const Choice& choice : choices_) add(choice, added);
    result_.edited = with_atoms(structure_, added);
    join();
    return std::move(result_);
  }

 private:
  void look_at(std::uint32_t residue) {
    SideChain side_chain(structure_, residues_, residue);
    if (side_chain.missing().empty()) return;
    if (!side_chain.can_be_built()) return result_.left.push_back(residue);
    choices_.push_back({std::move(side_chain)});
    centres_.push_back(residues_.find(residue, "CA"));
  }

  void find_surroundings() {
    std::vector<std::uint32_t> all(structure_.size());
    std::iota(all.begin(), all.end(), 0U);
    atoms_near_ = near_atoms(structure_, centres_, all, reach_of_atoms);
    const auto near = near_atoms(structure_, centres_, centres_, reach_of_side_chains);
    std::vector<std::uint32_t> number(structure_.size(), 0);
    for (std::uint32_t k = 0; k < centres_.size(); ++k) number[centres_[k]] = k;
    side_chains_near_ = Grouped<std::uint32_t>(centres_.size(), [&](const auto& put) {
      for (std::uint32_t k = 0; k < centres_.size(); ++k)
        for (std::uint32_t atom : near.at(k)) put(k, number[atom]);
    });
  }

  /// Atoms that bonds bring near do not count: the own residue but O, and what proline's N binds.
  bool may_run_into(const SideChain& side_chain, std::uint32_t atom) const {
    const std::uint32_t residue = structure_.atoms.residue_of[atom];
    const std::string& name = structure_.atoms.names[atom];
    if (residue == side_chain.residue()) return name == "O";
    const bool is_before = residue + 1 == side_chain.residue();
    return !(is_before && side_chain.is_proline() && (name == "C" || name == "O" || name == "CA"));
  }

  /// Atoms that the side chain should keep away from.
  std::vector<PlacedAtom> others(std::size_t k) const {
    std::vector<PlacedAtom> found;
    for (std::uint32_t atom : atoms_near_.at(k))
      if (may_run_into(choices_[k].side_chain, atom))
        found.push_back({structure_.positions[atom], structure_.atoms.elements[atom]});
    for (std::uint32_t other : side_chains_near_.at(k))
      found.insert(found.end(), choices_[other].atoms.begin(), choices_[other].atoms.end());
    return found;
  }

  /// The first of the usual torsions with the least sum of squared overlaps.
  void choose(std::size_t k) {
    auto& [side_chain, chosen, deepest_of_chosen] = choices_[k];
    const std::vector<PlacedAtom> surroundings = others(k);
    double least = std::numeric_limits<double>::infinity();
    const SideChainTurns none[] = {{}};
    for (const SideChainTurns& turn : side_chain.turns().empty() ? none : side_chain.turns()) {
      const std::vector<PlacedAtom> atoms = side_chain.placed(turn);
      const auto [overlaps, deepest] = overlap_of(atoms, surroundings);
      const double sum = overlaps + cost_of_strain * side_chain.strain();
      if (sum >= least) continue;
      least = sum;
      chosen = atoms;
      deepest_of_chosen = deepest;
      if (sum == 0.0) return;
    }
  }

  /// Sum of squares, and the deepest.
  static std::pair<double, double> overlap_of(const std::vector<PlacedAtom>& atoms,
                                              const std::vector<PlacedAtom>& others) {
    double sum = 0.0, deepest = 0.0;
    for (const PlacedAtom& atom : atoms)
      for (const PlacedAtom& other : others) {
        const double limit = least_distance(atom.element, other.element);
        const double squared = norm_squared(atom.position - other.position);
        if (squared >= limit * limit) continue;
        const double depth = limit - std::sqrt(squared);
        sum += depth * depth;
        deepest = std::max(deepest, depth);
      }
    return {sum, deepest};
  }

  void add(const Choice& choice, std::vector<NewAtom>& added) {
    const std::uint32_t residue = choice.side_chain.residue();
    const std::vector<std::string> names = choice.side_chain.missing();
    std::string listed;
    for (std::size_t k = 0; k < names.size(); ++k) {
      added.push_back({residues_.find(residue, "CA"), names[k], choice.atoms[k].element,
                       choice.atoms[k].position, false});
      listed += (listed.empty() ? "" : " ") + names[k];
    }
    result_.built.push_back({residue, listed, choice.overlap});
  }

  /// Bonds of the atoms that were built.
  void join() {
    Structure& whole = result_.edited.structure;
    const ResidueAtoms residues(whole.atoms);
    for (const auto& [side_chain, atoms, overlap] : choices_) {
      const auto rows = side_chain.rows();
      const std::uint32_t residue = side_chain.residue();
      const auto join_two = [&](std::string_view one, std::string_view other) {
        const std::uint32_t a = residues.find(residue, one), b = residues.find(residue, other);
        if (a == no_atom || b == no_atom) return;  // CD1 of ILE may be called CD
        const bool is_new =
            result_.edited.origin[a] == no_atom || result_.edited.origin[b] == no_atom;
        if (is_new) whole.bonds.push_back({std::min(a, b), std::max(a, b), BondOrigin::residue, 1});
      };
      join_two("CA", "CB");
      for (const SideChainAtom& row : rows) join_two(row.parent, row.name);
      for (const RingBond& ring : ring_bonds())
        if (!rows.empty() && ring.residue == rows.front().residue) join_two(ring.one, ring.other);
    }
    std::sort(whole.bonds.begin(), whole.bonds.end(), [](const Bond& one, const Bond& other) {
      return std::pair(one.a, one.b) < std::pair(other.a, other.b);
    });
  }

  const Structure& structure_;
  ResidueAtoms residues_;
  std::vector<Choice> choices_;
  std::vector<std::uint32_t> centres_;  ///< CA of each
  Grouped<std::uint32_t> atoms_near_, side_chains_near_;
  BuiltSideChains result_;
};

}  // namespace

BuiltSideChains build_side_chains(const Structure& structure) { return Builder(structure).build(); }

}  // namespace pliant
