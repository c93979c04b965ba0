// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/template_bonds.hpp"

#include <algorithm>

namespace pliant::perception {
namespace {

/// Bonds the atoms of one piece at a time; keeps its scratch between pieces.
class TemplateStep {
 public:
  explicit TemplateStep(Perception& perception) : p_(perception) {}

  void run() {
    const auto& residue_of = p_.structure.atoms.residue_of;
    const auto count = static_cast<std::uint32_t>(p_.structure.size());
    for (std::uint32_t first = 0, last = 0; first < count; first = last) {
      while (last < count && residue_of[last] == residue_of[first]) ++last;
      const auto& residue = p_.structure.atoms.residues[residue_of[first]];
      add_residue(first, last, find_residue_template(residue.name));
    }
  }

 private:
  void add_residue(std::uint32_t first, std::uint32_t last, const ResidueTemplate* shape) {
    piece_ = {first, last, shape};
    if (shape == nullptr) return p_.pieces.push_back(piece_);
    atom_at_.assign(shape->names.size(), none);
    for (std::uint32_t atom = first; atom < last; ++atom) place(atom);
    finish_unit(last);
  }

  /// Puts an atom where its name says; a name met before begins a new piece. Hydrogens that share a
  /// name, as programs that add them may call all of them H, have none: distances decide.
  void place(std::uint32_t atom) {
    const int slot = piece_.shape->find(p_.keys[atom]);
    if (slot == ResidueTemplate::none || p_.excluded[atom]) return;
    const std::uint32_t before = atom_at_[slot];
    p_.settled[atom] = true;
    if (before != none && lies_on(atom, before)) return;
    if (before != none && is_hydrogen(atom)) {
      p_.settled[before] = p_.settled[atom] = false;
      shared_.push_back(slot);
      return;
    }
    if (before != none) finish_unit(atom);
    atom_at_[slot] = atom;
  }

  bool is_hydrogen(std::uint32_t atom) const { return p_.structure.atoms.elements[atom] == 1; }

  bool lies_on(std::uint32_t atom, std::uint32_t earlier) {
    if (p_.length(atom, earlier) > p_.options.shortest) return false;
    p_.excluded[atom] = true;
    p_.repeated.add([&] { return p_.structure.atoms.label(atom); });
    return true;
  }

  void finish_unit(std::uint32_t last) {
    piece_.last = last;
    p_.pieces.push_back(piece_);
    for (const int slot : shared_) atom_at_[slot] = none;
    shared_.clear();
    for (const ResidueTemplate::Edge& edge : piece_.shape->edges)
      if (atom_at_[edge.a] != none && atom_at_[edge.b] != none)
        add_bond(atom_at_[edge.a], atom_at_[edge.b], edge.order);
    std::fill(atom_at_.begin(), atom_at_.end(), none);
    piece_.first = last;
  }

  void add_bond(std::uint32_t a, std::uint32_t b, std::uint8_t order) {
    if (p_.length(a, b) <= longest_template_bond(p_.structure, a, b))
      return p_.add(a, b, BondOrigin::residue, order);
    p_.stretched_bonds.push_back({std::min(a, b), std::max(a, b), BondOrigin::residue, order});
    p_.stretched.add([&] { return describe(a, b); });
    p_.settled[a] = p_.settled[b] = false;
  }

  std::string describe(std::uint32_t a, std::uint32_t b) const {
    char length[32];
    std::snprintf(length, sizeof length, ", %.2f", p_.length(a, b));
    return p_.structure.atoms.label(a) + " - " + p_.structure.atoms.label(b) + length;
  }

  static constexpr std::uint32_t none = 0xffffffffU;
  Perception& p_;
  ResiduePiece piece_;
  std::vector<std::uint32_t> atom_at_;  ///< by the template's numbers
  std::vector<int> shared_;             ///< numbers of hydrogens that share a name
};

}  // namespace

void add_template_bonds(Perception& perception) { TemplateStep(perception).run(); }

}  // namespace pliant::perception
