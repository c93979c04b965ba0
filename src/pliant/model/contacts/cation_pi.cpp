// SPDX-License-Identifier: MIT
// Cation-pi contacts: lysine or arginine over the face of an aromatic ring of phenylalanine,
// tyrosine or tryptophan, the pairs that Gallivan, Dougherty (Proc. Natl. Acad. Sci. USA 96 (1999)
// 9459) count. They are found by geometry as in PLIP (Salentin et al., Nucleic Acids Res. 43 (2015)
// W443): the charge is within 6 Angstrom of the ring's centre and within 2 of the axis through it.
#include <algorithm>
#include <map>
#include <utility>

#include "pliant/base/math/cell_list.hpp"
#include "pliant/base/words.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/model/contacts/polar_atoms.hpp"
#include "pliant/model/prepare/hydrogen_places.hpp"

namespace pliant {
namespace {

constexpr double furthest_charge = 6.0, furthest_from_axis = 2.0;  // Angstrom
/// kcal/mol: Gallivan and Dougherty count pairs from this electrostatic energy on.
constexpr double cation_pi_energy = -2.0;

/// Atoms around each ring, separated by blanks.
struct NamedRing {
  std::string_view residue, atoms;
};
constexpr NamedRing named_rings[] = {{"PHE", "CG CD1 CE1 CZ CE2 CD2"},
                                     {"TYR", "CG CD1 CE1 CZ CE2 CD2"},
                                     {"TRP", "CG CD1 NE1 CE2 CD2"},
                                     {"TRP", "CD2 CE2 CZ2 CH2 CZ3 CE3"}};

struct AromaticRing {
  std::uint32_t residue = 0;
  std::vector<std::uint32_t> atoms;
  Vec3 centre, axis;  ///< the axis has length 1
};

class CationPiFinder {
 public:
  explicit CationPiFinder(const Structure& structure)
      : structure_(structure), residues_(structure.atoms) {}

  std::vector<MolecularContact> find() {
    find_charges();
    for (std::uint32_t r = 0; r < structure_.atoms.residues.size(); ++r)
      for (const NamedRing& named : named_rings)
        if (standard(r) == named.residue) add_ring(r, named);
    find_pairs();
    std::vector<MolecularContact> found;
    for (const auto& [of, pair] : nearest_)
      found.push_back(contact_of(of.first, rings_[pair.ring]));
    sort(found);
    return found;
  }

 private:
  struct Pair {
    double apart;  ///< Angstrom, from the charge to the ring's centre
    std::size_t ring;
  };

  Vec3 at(std::uint32_t atom) const { return structure_.positions[atom]; }

  std::string_view standard(std::uint32_t residue) const {
    return standard_name(structure_.atoms.residues[residue].name);
  }

  /// NZ of lysine stands for its charge, and CZ, amid three N, for that of arginine.
  void find_charges() {
    const AtomGraph graph(structure_);
    const PolarAtoms polar(structure_, graph);
    for (std::uint32_t r = 0; r < structure_.atoms.residues.size(); ++r) {
      const bool is_lysine = standard(r) == "LYS";
      if (!is_lysine && standard(r) != "ARG") continue;
      const std::uint32_t atom = residues_.find(r, is_lysine ? "NZ" : "CZ");
      if (atom != no_atom && (!is_lysine || polar.is_positive(atom))) charges_.push_back(atom);
    }
  }

  void add_ring(std::uint32_t residue, const NamedRing& named) {
    AromaticRing ring;
    ring.residue = residue;
    for (const std::string_view name : words_of(named.atoms)) {
      ring.atoms.push_back(residues_.find(residue, name));
      if (ring.atoms.back() == no_atom) return;
      ring.centre += at(ring.atoms.back());
    }
    const std::size_t size = ring.atoms.size();
    ring.centre *= 1.0 / static_cast<double>(size);
    Vec3 area;
    for (std::size_t k = 0; k < size; ++k)
      area += cross(at(ring.atoms[k]) - ring.centre, at(ring.atoms[(k + 1) % size]) - ring.centre);
    ring.axis = unit_vector(area);
    rings_.push_back(std::move(ring));
  }

  /// Of the rings of one residue, a charge has the one whose centre is nearest.
  void find_pairs() {
    std::vector<Vec3> points;
    for (const std::uint32_t atom : charges_) points.push_back(at(atom));
    for (const AromaticRing& ring : rings_) points.push_back(ring.centre);
    const std::size_t first_ring = charges_.size();
    const auto look_at = [&](std::uint32_t charge, std::uint32_t other, double) {
      if (charge >= first_ring || other < first_ring) return;
      const std::size_t ring = other - first_ring;
      const Vec3 way = points[charge] - rings_[ring].centre;
      const double apart = norm(way);
      if (apart >= furthest_charge || off_axis(way, rings_[ring]) >= furthest_from_axis) return;
      const Pair here{apart, ring};
      Pair& best =
          nearest_.try_emplace({charges_[charge], rings_[ring].residue}, here).first->second;
      if (apart < best.apart) best = here;
    };
    CellList(points, furthest_charge).for_each_pair(look_at);
  }

  static double off_axis(Vec3 way, const AromaticRing& ring) {
    return norm(way - dot(way, ring.axis) * ring.axis);
  }

  /// Holds the charge to the ring's atom that is nearest to it.
  MolecularContact contact_of(std::uint32_t charge, const AromaticRing& ring) const {
    const auto is_nearer = [&](std::uint32_t one, std::uint32_t other) {
      return distance(at(charge), at(one)) < distance(at(charge), at(other));
    };
    const std::uint32_t nearest =
        *std::min_element(ring.atoms.begin(), ring.atoms.end(), is_nearer);
    MolecularContact contact{MolecularContactKind::cation_pi, charge, nearest};
    contact.energy = cation_pi_energy;
    set_limits(contact, structure_);
    return contact;
  }

  const Structure& structure_;
  ResidueAtoms residues_;
  std::vector<std::uint32_t> charges_;
  std::vector<AromaticRing> rings_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, Pair> nearest_;  ///< by charge and residue
};

}  // namespace

std::vector<MolecularContact> find_cation_pi(const Structure& structure, const ContactOptions&) {
  return CationPiFinder(structure).find();
}

}  // namespace pliant
