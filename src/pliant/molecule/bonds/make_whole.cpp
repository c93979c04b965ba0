// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/make_whole.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/molecule/bonds/cell_bonds.hpp"

namespace pliant::perception {
namespace {

CellShift sum(CellShift one, const CellShift& other, int sign) {
  for (std::size_t k = 0; k < 3; ++k) one[k] += sign * other[k];
  return one;
}

/// A bond as one of its atoms sees it.
struct Step {
  std::uint32_t to;
  CellShift shift;  ///< of `to`, to be beside the atom
};

/// Bonds as they lie, and those through the cell.
Grouped<Step> steps_of(const Perception& p, const std::vector<CellBond>& through) {
  return Grouped<Step>(p.structure.size(), [&](const auto& put) {
    for (const Bond& bond : p.bonds) {
      if (bond.origin == BondOrigin::file && p.length(bond.a, bond.b) > longest_stated) continue;
      put(bond.a, Step{bond.b, no_shift});
      put(bond.b, Step{bond.a, no_shift});
    }
    for (const CellBond& bond : through) {
      put(bond.a, Step{bond.b, bond.shift});
      put(bond.b, Step{bond.a, sum(no_shift, bond.shift, -1)});
    }
  });
}

/// The shifts of atoms that make molecules whole.
class Walk {
 public:
  Walk(const Perception& perception, const std::vector<CellBond>& through)
      : steps_(steps_of(perception, through)),
        shifts_(perception.structure.size(), no_shift),
        is_seen_(perception.structure.size(), false) {
    for (const CellBond& bond : through)
      if (!is_seen_[bond.a]) walk(bond.a);
  }

  /// Atoms of a molecule in the order of the walk.
  struct Molecule {
    std::vector<std::uint32_t> atoms;
    std::size_t moved = 0;
  };
  const std::vector<Molecule>& molecules() const { return molecules_; }
  CellShift shift(std::uint32_t atom) const { return shifts_[atom]; }

 private:
  void walk(std::uint32_t first) {
    Molecule molecule{{first}};
    is_seen_[first] = true;
    bool is_endless = false;
    for (std::size_t k = 0; k < molecule.atoms.size(); ++k) {
      const std::uint32_t from = molecule.atoms[k];
      for (const Step& step : steps_.at(from)) {
        const CellShift shift = sum(shifts_[from], step.shift, 1);
        is_endless |= is_seen_[step.to] && shifts_[step.to] != shift;
        if (is_seen_[step.to]) continue;
        is_seen_[step.to] = true;
        shifts_[step.to] = shift;
        molecule.atoms.push_back(step.to);
      }
    }
    if (is_endless) {
      for (std::uint32_t atom : molecule.atoms) shifts_[atom] = no_shift;
      return;
    }
    keep_most_in_place(molecule);
    if (molecule.moved > 0) molecules_.push_back(std::move(molecule));
  }

  void keep_most_in_place(Molecule& molecule) {
    std::map<CellShift, std::size_t> counts;
    for (std::uint32_t atom : molecule.atoms) ++counts[shifts_[atom]];
    const auto most = std::max_element(
        counts.begin(), counts.end(),
        [](const auto& one, const auto& other) { return one.second < other.second; });
    for (std::uint32_t atom : molecule.atoms) shifts_[atom] = sum(shifts_[atom], most->first, -1);
    molecule.moved = molecule.atoms.size() - most->second;
  }

  Grouped<Step> steps_;
  std::vector<CellShift> shifts_;
  std::vector<bool> is_seen_;
  std::vector<Molecule> molecules_;
};

/// "A:MET1 to A:GLY214", or one atom of a molecule that is one residue.
std::string named(const Structure& structure, const std::vector<std::uint32_t>& atoms) {
  const auto [first, last] = std::minmax_element(atoms.begin(), atoms.end());
  const auto& residue_of = structure.atoms.residue_of;
  const std::string begin = structure.atoms.label(*first);
  if (residue_of[*first] == residue_of[*last]) return "that of " + begin;
  return begin + " to " + structure.atoms.label(*last);
}

void tell(const Structure& structure, const std::vector<Walk::Molecule>& molecules,
          const Log& log) {
  constexpr std::size_t most_named = 3;
  std::size_t moved = 0;
  std::string names;
  for (std::size_t k = 0; k < molecules.size(); ++k) {
    moved += molecules[k].moved;
    if (k < most_named) names += (k > 0 ? ", " : "") + named(structure, molecules[k].atoms);
  }
  if (molecules.size() > most_named)
    names += " and " + std::to_string(molecules.size() - most_named) + " more";
  const std::string file = structure.source.empty() ? "" : structure.source + ": ";
  log.note(file + std::to_string(molecules.size()) +
           (molecules.size() == 1 ? " molecule" : " molecules") +
           " cut by the periodic cell made whole (" + names + "): " + std::to_string(moved) +
           (moved == 1 ? " atom" : " atoms") + " moved by edges of the cell");
}

}  // namespace

bool make_whole(Structure& structure, const Perception& perception) {
  if (!structure.cell) return false;
  const std::vector<CellBond> through = cell_bonds(perception);
  if (through.empty()) return false;
  const Walk walk(perception, through);
  if (walk.molecules().empty()) return false;
  for (const Walk::Molecule& molecule : walk.molecules())
    for (std::uint32_t atom : molecule.atoms)
      if (walk.shift(atom) != no_shift)
        structure.positions[atom] += (*structure.cell)(walk.shift(atom));
  tell(structure, walk.molecules(), perception.options.log);
  return true;
}

}  // namespace pliant::perception
