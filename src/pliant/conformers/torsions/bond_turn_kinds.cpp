// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/bond_turn_kinds.hpp"

#include <algorithm>
#include <utility>

namespace pliant {
namespace {

constexpr std::uint8_t carbon = 6, nitrogen = 7, oxygen = 8, fluorine = 9, phosphorus = 15,
                       sulphur = 16;

/// Tells the kind of a bond.
class TurnKinds {
 public:
  explicit TurnKinds(const BondChemistry& chemistry) : chemistry_(chemistry) {}

  BondTurn of(Joint a, Joint b) const {
    if (is_aryl(a) && is_aryl(b)) return biaryl(a, b);
    for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)})
      if (const BondTurn kind = by_first(one, other); kind != BondTurn::any) return kind;
    if (!chemistry_.is_tetrahedral(a) || !chemistry_.is_tetrahedral(b)) {
      const bool both = !chemistry_.is_tetrahedral(a) && !chemistry_.is_tetrahedral(b);
      return both ? BondTurn::conjugated : BondTurn::any;
    }
    return tetrahedral(a, b);
  }

 private:
  std::uint8_t element(Joint atom) const { return chemistry_.element(atom); }
  std::size_t bonds(Joint atom) const { return chemistry_.bonds_at(atom).size(); }
  int heavy(Joint atom) const { return chemistry_.heavy_bonds_at(atom); }
  bool bears_hydrogen(Joint atom) const { return heavy(atom) < int(bonds(atom)); }
  bool is_alkyl(Joint atom) const { return element(atom) == carbon && bonds(atom) == 4; }
  bool is_sulfonyl(Joint atom) const { return element(atom) == sulphur && bonds(atom) == 4; }
  bool is_hetero(Joint atom) const {
    const std::uint8_t at = element(atom);
    return at == nitrogen || at == oxygen || at == fluorine;
  }
  bool is_aryl(Joint atom) const { return chemistry_.is_aryl(atom); }

  template <class Holds>
  int beside(Joint atom, Joint except, Holds holds) const {
    const auto around = chemistry_.bonds_at(atom);
    return int(std::count_if(around.begin(), around.end(), [&](const Link& bond) {
      return bond.node != except && holds(bond.node);
    }));
  }
  bool is_acylated(Joint atom) const {
    return beside(atom, atom, [&](Joint at) { return chemistry_.is_acyl(at); }) > 0;
  }
  bool is_beside_sulfonyl(Joint atom) const {
    return beside(atom, atom, [&](Joint at) { return is_sulfonyl(at); }) > 0;
  }
  /// Atoms of the ring beside the bond that bear heavy atoms.
  int ortho(Joint aryl, Joint to) const {
    return beside(aryl, to, [&](Joint at) { return heavy(at) > 2; });
  }
  /// Atoms of the ring beside the bond that bear nothing.
  int bare(Joint aryl, Joint to) const {
    return beside(aryl, to, [&](Joint at) { return bonds(at) == 2; });
  }

  BondTurn by_first(Joint a, Joint b) const {
    if (chemistry_.is_ester(a, b)) return BondTurn::ester;
    if (chemistry_.is_acyl(a) && element(b) == oxygen) return BondTurn::acid;
    if (is_aryl(a)) return from_aryl(a, b);
    if (is_alkyl(b)) return to_alkyl(a, b);
    if (is_sulfonyl(a) && element(b) == nitrogen) return BondTurn::sulfonamide;
    if (element(a) == nitrogen && element(b) == nitrogen) return BondTurn::hydrazine;
    if (element(a) == phosphorus && element(b) == oxygen) return BondTurn::phosphate;
    if (element(a) == sulphur && element(b) == sulphur) return BondTurn::disulfide;
    return BondTurn::any;
  }

  BondTurn biaryl(Joint a, Joint b) const {
    const int crowd = ortho(a, b) + ortho(b, a);
    if (crowd > 2) return BondTurn::atropisomer;
    if (crowd > 0) return crowd > 1 ? BondTurn::biaryl_flanked : BondTurn::biaryl_ortho;
    return bare(a, b) + bare(b, a) > 0 ? BondTurn::biaryl_plane : BondTurn::biaryl;
  }

  BondTurn from_aryl(Joint aryl, Joint to) const {
    const int crowd = ortho(aryl, to);
    if (element(to) == oxygen && bonds(to) == 2) return aryl_oxygen(aryl, to, crowd);
    if (element(to) == sulphur) return aryl_sulphur(aryl, to, crowd);
    if (element(to) == nitrogen && bonds(to) == 3) return aryl_nitrogen(aryl, to, crowd);
    if (chemistry_.is_acyl(to)) return aryl_acyl(aryl, to, crowd);
    if (is_alkyl(to)) return flat_alkyl(aryl, to);
    if (chemistry_.is_tetrahedral(to)) return BondTurn::any;
    return crowd > 0 ? BondTurn::aryl_acyl_ortho : BondTurn::aryl_vinyl;
  }

  BondTurn aryl_oxygen(Joint aryl, Joint to, int crowd) const {
    if (bears_hydrogen(to)) return BondTurn::in_plane;
    if (crowd > 1) return BondTurn::flanked;
    if (is_acylated(to)) return BondTurn::aryl_ester;
    if (beside(to, aryl, [&](Joint at) { return is_aryl(at); }) > 0) return BondTurn::diaryl;
    const bool is_small = beside(to, aryl, [&](Joint at) { return heavy(at) < 3; }) > 0;
    return is_small ? BondTurn::aryl_ether : BondTurn::aryl_ether_branched;
  }

  BondTurn aryl_sulphur(Joint aryl, Joint to, int crowd) const {
    if (bonds(to) > 2) return BondTurn::aryl_sulfonyl;
    if (bears_hydrogen(to)) return BondTurn::in_plane;
    if (crowd > 1) return BondTurn::flanked;
    const bool both = beside(to, aryl, [&](Joint at) { return is_aryl(at); }) > 0;
    return both ? BondTurn::diaryl : BondTurn::aryl_sulfide;
  }

  BondTurn aryl_nitrogen(Joint aryl, Joint to, int crowd) const {
    if (beside(to, aryl, [&](Joint at) { return bonds(at) == 1 && element(at) == oxygen; }) > 1)
      return by_crowd(crowd, BondTurn::in_plane, BondTurn::aryl_acyl_ortho,
                      BondTurn::aryl_acyl_flanked);
    if (is_beside_sulfonyl(to)) return BondTurn::aryl_sulfonamide;
    if (is_acylated(to)) {
      if (!bears_hydrogen(to)) return BondTurn::aryl_acylated;
      if (crowd == 0 && bare(aryl, to) > 0) return BondTurn::aryl_ketone;
      return crowd > 0 ? BondTurn::aryl_amide_ortho : BondTurn::aryl_amide;
    }
    return by_crowd(crowd, BondTurn::aryl_amine, BondTurn::aryl_amine_ortho, BondTurn::off_plane);
  }

  BondTurn aryl_acyl(Joint aryl, Joint to, int crowd) const {
    if (crowd > 2) return BondTurn::atropisomer;
    if (crowd > 0) return crowd > 1 ? BondTurn::aryl_acyl_flanked : BondTurn::aryl_acyl_ortho;
    const bool is_secondary = beside(to, aryl, [&](Joint at) {
                                return element(at) == nitrogen && bears_hydrogen(at);
                              }) > 0;
    const bool has_nitrogen =
        beside(aryl, to, [&](Joint at) { return element(at) == nitrogen && bonds(at) == 2; }) > 0;
    if (is_secondary && has_nitrogen) return BondTurn::pyridyl_amide;
    const bool is_amide = beside(to, aryl, [&](Joint at) { return element(at) == nitrogen; }) > 0;
    return is_amide && bare(aryl, to) == 0 ? BondTurn::aryl_acyl : BondTurn::aryl_ketone;
  }

  static BondTurn by_crowd(int crowd, BondTurn none, BondTurn one, BondTurn more) {
    if (crowd == 0) return none;
    return crowd == 1 ? one : more;
  }

  BondTurn flat_alkyl(Joint flat, Joint to) const {
    if (heavy(to) > 2) return heavy(to) == 3 ? BondTurn::flat_branched : BondTurn::flat_quaternary;
    const bool is_polar = beside(to, flat, [&](Joint at) { return is_hetero(at); }) > 0;
    return is_polar && element(flat) == carbon ? BondTurn::flat_hetero : BondTurn::flat_primary;
  }

  /// From an atom other than aryl.
  BondTurn to_alkyl(Joint from, Joint to) const {
    if (chemistry_.is_acyl(from)) return acyl_alkyl(from, to);
    if (element(from) == nitrogen && is_flat_nitrogen(from)) return nitrogen_alkyl(from, to);
    if (element(from) == oxygen && !bears_hydrogen(from) && is_esterified(from))
      return by_crowd(heavy(to) - 2, BondTurn::ester_alkyl, BondTurn::ester_branched,
                      BondTurn::staggered);
    const bool is_vinyl = element(from) == carbon && bonds(from) == 3;
    return is_vinyl && !chemistry_.is_tetrahedral(from) ? BondTurn::allyl : BondTurn::any;
  }

  bool is_flat_nitrogen(Joint atom) const {
    return bonds(atom) == 3 && (chemistry_.is_conjugated(atom) || is_beside_sulfonyl(atom) ||
                                beside(atom, atom, [&](Joint at) { return is_aryl(at); }) > 0);
  }

  bool is_esterified(Joint atom) const {
    return is_acylated(atom) ||
           beside(atom, atom, [&](Joint at) { return element(at) == phosphorus; }) > 0;
  }

  BondTurn nitrogen_alkyl(Joint from, Joint to) const {
    if (is_beside_sulfonyl(from))
      return heavy(to) > 3 ? BondTurn::staggered : BondTurn::sulfonamide_alkyl;
    if (!bears_hydrogen(from)) return flat_alkyl(from, to);
    return by_crowd(heavy(to) - 2, BondTurn::amide_alkyl, BondTurn::amide_branched,
                    BondTurn::staggered);
  }

  BondTurn acyl_alkyl(Joint from, Joint to) const {
    if (heavy(to) > 2) return heavy(to) == 3 ? BondTurn::acyl_branched : BondTurn::staggered;
    if (beside(to, from, [&](Joint at) { return is_aryl(at); }) > 0) return BondTurn::acyl_benzyl;
    const bool is_polar =
        beside(to, from, [&](Joint at) { return is_hetero(at) || element(at) == sulphur; }) > 0;
    return is_polar ? BondTurn::acyl_hetero : BondTurn::acyl_alkyl;
  }

  BondTurn tetrahedral(Joint a, Joint b) const {
    if (is_alkyl(a) && is_alkyl(b)) return alkyl(a, b);
    if (is_alkyl(b)) return hetero_alkyl(a, b);
    return is_alkyl(a) ? hetero_alkyl(b, a) : BondTurn::staggered;
  }

  BondTurn alkyl(Joint a, Joint b) const {
    if (heavy(a) > 2 || heavy(b) > 2) return BondTurn::staggered;
    const bool both =
        is_hetero(chemistry_.reference(a, b)) && is_hetero(chemistry_.reference(b, a));
    return both ? BondTurn::gauche : BondTurn::alkyl;
  }

  BondTurn hetero_alkyl(Joint from, Joint to) const {
    if (heavy(from) != 2) return BondTurn::staggered;
    if (heavy(to) > 2)
      return heavy(to) == 3 && element(from) == oxygen ? BondTurn::ether_branched
                                                       : BondTurn::staggered;
    if (element(from) == oxygen) return BondTurn::ether;
    return element(from) == sulphur ? BondTurn::thioether : BondTurn::amine;
  }

  const BondChemistry& chemistry_;
};

}  // namespace

BondTurn turn_of(const BondChemistry& chemistry, Joint a, Joint b) {
  return TurnKinds(chemistry).of(a, b);
}

std::vector<std::array<Joint, 4>> atropisomer_axes(const BondChemistry& chemistry) {
  std::vector<std::array<Joint, 4>> found;
  for (Joint a = 0; a < chemistry.atoms(); ++a)
    for (const Link& bond : chemistry.bonds_at(a)) {
      const Joint b = bond.node;
      if (b < a || turn_of(chemistry, a, b) != BondTurn::atropisomer) continue;
      const Joint one = chemistry.reference(a, b), other = chemistry.reference(b, a);
      const std::vector<Joint> hung = chemistry.beyond(a, {b});
      if (std::find(hung.begin(), hung.end(), other) == hung.end())
        found.push_back({one, a, b, other});
    }
  return found;
}

BondTurn turn_in_loop(const BondChemistry& chemistry, Joint a, Joint b) {
  const BondTurn kind = turn_of(chemistry, a, b);
  if (stays(kind)) return kind;
  if (chemistry.is_ring_amide(a, b, false) || chemistry.is_ring_amide(b, a, false))
    return BondTurn::ring_amide;
  const auto is_acylated = [&](Joint at) {
    return (chemistry.is_oxygen(at) || chemistry.is_nitrogen(at)) && chemistry.is_conjugated(at);
  };
  if ((is_acylated(a) && chemistry.bonds_at(b).size() == 4) ||
      (is_acylated(b) && chemistry.bonds_at(a).size() == 4))
    return BondTurn::beside_acyl;
  return kind;
}

}  // namespace pliant
