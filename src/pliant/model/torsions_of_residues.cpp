// SPDX-License-Identifier: MIT
#include "pliant/model/torsions_of_residues.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/side_chain_geometry.hpp"

namespace pliant {
namespace {

/// Angles at tetrahedral atoms are below, at planar ones above (degrees; see the table's rows).
constexpr double widest_tetrahedral = 117.0;
/// Rotamers spread by some 10 to 15 degrees (S. C. Lovell et al., Proteins 40 (2000) 389).
constexpr double usual_spread = 15.0 * std::numbers::pi / 180.0;

class Finder {
 public:
  explicit Finder(const Structure& structure)
      : structure_(structure), graph_(structure), residues_(structure.atoms) {}

  TorsionPreferences find() {
    for (std::uint32_t r = 0; r < structure_.atoms.residues.size(); ++r) {
      if (!is_amino_acid(structure_.atoms.residues[r])) continue;
      const std::string_view name = standard_name(structure_.atoms.residues[r].name);
      if (name != "PRO")  // its ring keeps them
        for (const SideChainAtom& row : side_chain_geometry(name)) look_at(r, row);
      if (name != "GLY") look_at_backbone(r);
    }
    return std::move(found_);
  }

 private:
  template <std::size_t size>
  static bool are_there(const std::array<std::uint32_t, size>& atoms) {
    return std::find(atoms.begin(), atoms.end(), no_atom) == atoms.end();
  }

  double torsion_of(const std::array<std::uint32_t, 4>& at) const {
    const auto& x = structure_.positions;
    return torsion_angle(x[at[0]], x[at[1]], x[at[2]], x[at[3]]);
  }

  void look_at(std::uint32_t residue, const SideChainAtom& row) {
    if (row.chi == 0 || row.angle > widest_tetrahedral) return;
    const std::array<std::uint32_t, 4> atoms{
        residues_.find(residue, row.reference), residues_.find(residue, row.neighbour),
        residues_.find(residue, row.parent), residues_.find(residue, row.name)};
    if (!are_there(atoms)) return;
    const double off = std::abs(off_staggered(torsion_of(atoms)));
    found_.staggered.push_back({atoms, std::max(usual_spread, off)});
  }

  /// The backbone atom of that name in another residue, bonded to `atom`; no_atom if none.
  std::uint32_t beyond(std::uint32_t atom, std::string_view name) const {
    if (atom == no_atom) return no_atom;
    const auto& residue_of = structure_.atoms.residue_of;
    for (const Link& link : graph_.at(atom))
      if (residue_of[link.node] != residue_of[atom] && structure_.atoms.names[link.node] == name)
        return link.node;
    return no_atom;
  }

  void look_at_backbone(std::uint32_t residue) {
    const std::uint32_t n = residues_.find(residue, "N"), ca = residues_.find(residue, "CA"),
                        c = residues_.find(residue, "C");
    const std::array<std::uint32_t, 5> atoms{beyond(n, "C"), n, ca, c, beyond(c, "N")};
    if (!are_there(atoms)) return;
    const double reach =
        backbone_reach(torsion_of({atoms[0], n, ca, c}), torsion_of({n, ca, c, atoms[4]}));
    found_.backbone.push_back({atoms, std::max(1.0, reach)});
  }

  const Structure& structure_;
  AtomGraph graph_;
  ResidueAtoms residues_;
  TorsionPreferences found_;
};

}  // namespace

TorsionPreferences torsions_of_residues(const Structure& structure) {
  return Finder(structure).find();
}

}  // namespace pliant
