// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/polar_hydrogens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "pliant/base/math/elementary.hpp"
#include "pliant/base/words.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/near_atoms.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/hydrogen_places.hpp"

namespace pliant {
namespace {

constexpr double acceptor_reach = 2.7;  // Angstrom from H
constexpr double longest_bond = 1.34;   // Angstrom, S-H
constexpr std::uint8_t oxygen = 8, sulphur = 16;

double bond_length(std::uint8_t parent) {
  return parent == oxygen ? 0.96 : parent == sulphur ? longest_bond : 1.01;
}

/// An atom that lacks hydrogens, and how they sit.
struct Site {
  std::uint32_t parent;
  std::string_view names;
  HydrogenShape shape;
  BondAngle angle = tetrahedral_angle;
};

/// Finds the sites of a structure, residue by residue.
class SiteFinder {
 public:
  SiteFinder(const Structure& structure, const Protonation& protonation)
      : structure_(structure),
        protonation_(protonation),
        graph_(structure),
        residues_(structure.atoms) {}

  std::vector<Site> find() {
    for (std::size_t r = 0; r < structure_.atoms.residues.size(); ++r) {
      const Residue& residue = structure_.atoms.residues[r];
      if (is_water(residue)) continue;
      const bool is_peptide = has_peptide_backbone(r);
      if (is_peptide && !has_hydrogen(r, true)) add_backbone(r);
      if (is_cap(residue) && !has_hydrogen(r, true)) add_cap(r);
      if (has_hydrogen(r, false) && !protonation_.is_asked_for[r] && !lacks_one(residue)) continue;
      add_side_chain(r);
      if (is_nucleotide(residue)) add_sugar(r);
    }
    std::sort(sites_.begin(), sites_.end(),
              [](const Site& one, const Site& other) { return one.parent < other.parent; });
    return std::move(sites_);
  }

 private:
  /// The ring of histidine has a hydrogen on nitrogen always; files of programs that build those on
  /// carbon alone lack it. Other side chains may have none by their form.
  static bool lacks_one(const Residue& residue) { return standard_name(residue.name) == "HIS"; }

  bool has_peptide_backbone(std::size_t residue) const {
    return residues_.find(residue, "N") != no_atom && residues_.find(residue, "CA") != no_atom &&
           residues_.find(residue, "C") != no_atom;
  }

  /// Whether the backbone or the rest of a residue has a hydrogen.
  bool has_hydrogen(std::size_t residue, bool of_backbone) const {
    for (std::uint32_t atom = residues_.begin(residue); atom < residues_.end(residue); ++atom)
      if (is_backbone(structure_.atoms.names[atom]) == of_backbone && graph_.hydrogens_at(atom) > 0)
        return true;
    return false;
  }

  void add_backbone(std::size_t residue) {
    const std::uint32_t n = residues_.find(residue, "N");
    const bool is_ring = residues_.find(residue, "CD") != no_atom &&
                         graph_.are_bonded(n, residues_.find(residue, "CD"));
    const bool is_amide =
        is_acylated(structure_, graph_, n) || structure_.atoms.residues[residue].name == "PCA";
    if (begins_chain(residue) && !is_amide) {
      if (is_ring) add({n, "H2 H3", HydrogenShape::tetrahedral}, 2);
      if (!is_ring) add({n, "H1 H2 H3", HydrogenShape::spinning}, 1);
    } else if (!is_ring || is_amide) {
      const std::size_t heavy = graph_.heavy_at(n).size();
      if (heavy == 1) sites_.push_back({n, "H", HydrogenShape::spinning, planar_angle});
      if (heavy == 2) sites_.push_back({n, "H", HydrogenShape::bisector});
    }
  }

  /// Adds a site whose atom has `usual` heavy neighbours. Each further one takes the place of a
  /// hydrogen, and an ammonium group that becomes an amide loses one more with its charge.
  void add(Site site, std::size_t usual) {
    const std::size_t heavy = graph_.heavy_at(site.parent).size();
    if (heavy < usual) return;
    if (heavy == usual) return sites_.push_back(site);
    const Words names = words_of(site.names);
    const bool is_amide = is_acylated(structure_, graph_, site.parent);
    const bool is_ammonium = names.size() + usual == 4;
    const std::size_t taken = heavy - usual + (is_ammonium && is_amide ? 1 : 0);
    if (taken >= names.size()) return;
    site.names.remove_prefix(static_cast<std::size_t>(names[taken].data() - site.names.data()));
    const bool is_flat = is_amide || site.shape == HydrogenShape::in_plane;
    site.shape = heavy == 3 ? HydrogenShape::opposite
                 : is_flat  ? HydrogenShape::bisector
                            : HydrogenShape::tetrahedral;
    sites_.push_back(site);
  }

  /// Whether nothing of the chain comes before a residue, so that its N is a chain's own end.
  bool begins_chain(std::size_t residue) const {
    if (residue == 0) return true;
    const auto& all = structure_.atoms.residues;
    if (all[residue - 1].chain != all[residue].chain) return true;
    if (!structure_.chain_end.empty() && structure_.chain_end[residue - 1]) return true;
    return !has_peptide_backbone(residue - 1);
  }

  void add_cap(std::size_t residue) {
    const std::uint32_t n = residues_.find(residue, "N");
    if (n == no_atom) return;
    const std::size_t heavy = graph_.heavy_at(n).size();
    if (heavy == 2) sites_.push_back({n, "H", HydrogenShape::bisector});
    if (heavy == 1) sites_.push_back({n, "HN1 HN2", HydrogenShape::in_plane});
  }

  void add_side_chain(std::size_t residue) {
    for (const PolarSite& row : polar_sites()) {
      if (row.form != protonation_.forms[residue]) continue;
      const std::uint32_t atom = residues_.find(residue, row.atom);
      if (atom == no_atom || graph_.hydrogens_at(atom) > 0) continue;
      const bool is_thiol = structure_.atoms.elements[atom] == sulphur;
      add({atom, row.hydrogens, row.shape, is_thiol ? thiol_angle : tetrahedral_angle},
          row.shape == HydrogenShape::bisector ? 2 : 1);
    }
  }

  /// Hydroxyl groups of a nucleotide: O2', and O3' and O5' that no phosphate takes.
  void add_sugar(std::size_t residue) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> hydroxyls{
        {{"O2'", "HO2'"},
         {"O3'", "HO3'"},
         {"O5'", "HO5'"},
         {"O2*", "HO2'"},
         {"O3*", "HO3'"},
         {"O5*", "HO5'"}}};
    for (const auto& [name, hydrogen] : hydroxyls) {
      const std::uint32_t atom = residues_.find(residue, name);
      if (atom != no_atom && graph_.heavy_at(atom).size() == 1)
        sites_.push_back({atom, hydrogen, HydrogenShape::spinning});
    }
  }

  const Structure& structure_;
  const Protonation& protonation_;
  AtomGraph graph_;
  ResidueAtoms residues_;
  std::vector<Site> sites_;
};

/// Places the hydrogens of sites.
class Placer {
 public:
  Placer(const Structure& structure, const std::vector<Site>& sites)
      : structure_(structure), graph_(structure), sites_(sites) {
    std::vector<std::uint32_t> parents, oxygens;
    for (const Site& site : sites) parents.push_back(site.parent);
    for (std::uint32_t i = 0; i < structure.size(); ++i)
      if (structure.atoms.elements[i] == oxygen) oxygens.push_back(i);
    oxygens_ = near_atoms(structure, parents, oxygens, acceptor_reach + longest_bond);
  }

  std::vector<PlacedHydrogen> place() {
    for (std::size_t k = 0; k < sites_.size(); ++k) {
      const Words names = words_of(sites_[k].names);
      const std::vector<Vec3> places = places_of(k, names.size());
      for (std::size_t h = 0; h < places.size(); ++h)
        placed_.push_back({sites_[k].parent, std::string(names[h]), places[h]});
    }
    return std::move(placed_);
  }

 private:
  Vec3 at(std::uint32_t atom) const { return structure_.positions[atom]; }

  std::vector<Vec3> places_of(std::size_t k, std::size_t count) const {
    const Site& site = sites_[k];
    const std::vector<std::uint32_t> heavy = graph_.heavy_at(site.parent);
    const Vec3 parent = at(site.parent);
    const double length = bond_length(structure_.atoms.elements[site.parent]);
    switch (site.shape) {
      case HydrogenShape::bisector:
        return {against_both(parent, at(heavy[0]), at(heavy[1]), length)};
      case HydrogenShape::tetrahedral: {
        std::vector<Vec3> places{out_of_plane(parent, at(heavy[0]), at(heavy[1]), length, 1.0),
                                 out_of_plane(parent, at(heavy[0]), at(heavy[1]), length, -1.0)};
        places.resize(count);
        return places;
      }
      case HydrogenShape::opposite:
        return {against_three(parent, at(heavy[0]), at(heavy[1]), at(heavy[2]), length)};
      case HydrogenShape::in_plane:
        return around(k, heavy[0], count, planar_angle, 0, 18);
      case HydrogenShape::spinning:
      case HydrogenShape::conjugated:
        return around(k, heavy[0], count, site.angle, best_torsion(k, heavy[0], count), 12);
    }
    return {};
  }

  /// The lightest heavy atom beyond the neighbour, the first of equal ones.
  std::uint32_t reference_of(std::uint32_t parent, std::uint32_t neighbour) const {
    const auto& elements = structure_.atoms.elements;
    std::uint32_t best = no_atom;
    for (std::uint32_t atom : graph_.heavy_at(neighbour))
      if (atom != parent && (best == no_atom || elements[atom] < elements[best])) best = atom;
    return best;
  }

  Spin spin_of(const Site& site, std::uint32_t neighbour) const {
    const std::uint32_t reference = reference_of(site.parent, neighbour);
    const Vec3 from =
        reference != no_atom
            ? at(reference)
            : at(neighbour) + perpendicular_to(unit_vector(at(neighbour) - at(site.parent)));
    return {from, at(neighbour), at(site.parent)};
  }

  std::vector<Vec3> around(std::size_t k, std::uint32_t neighbour, std::size_t count,
                           BondAngle angle, int first, int step) const {
    const Site& site = sites_[k];
    const Spin spin = spin_of(site, neighbour);
    const double length = bond_length(structure_.atoms.elements[site.parent]);
    std::vector<Vec3> places;
    for (std::size_t h = 0; h < count; ++h)
      places.push_back(spin.at(length, angle, first + static_cast<int>(h) * step));
    return places;
  }

  /// The best torsion in tens of degrees; the first of equal ones.
  int best_torsion(std::size_t k, std::uint32_t neighbour, std::size_t count) const {
    const bool is_flat = sites_[k].shape == HydrogenShape::conjugated;
    int best = 0;
    double lowest = 1e300;
    for (int tens = 0; tens < 36; ++tens) {
      double energy = is_flat ? -0.02 * cosine_of_tens(2 * tens) : 0.02 * cosine_of_tens(3 * tens);
      for (Vec3 hydrogen : around(k, neighbour, count, sites_[k].angle, tens, 12))
        energy -= attraction(k, neighbour, hydrogen);
      if (energy < lowest) {
        lowest = energy;
        best = tens;
      }
    }
    return best;
  }

  double attraction(std::size_t k, std::uint32_t neighbour, Vec3 hydrogen) const {
    const std::uint32_t parent = sites_[k].parent;
    double sum = 0.0;
    for (std::uint32_t acceptor : oxygens_.at(k)) {
      const double apart = distance(hydrogen, at(acceptor));
      if (apart > acceptor_reach || graph_.are_bonded(neighbour, acceptor)) continue;
      const double straight =
          -dot(unit_vector(at(parent) - hydrogen), unit_vector(at(acceptor) - hydrogen));
      if (straight <= 0.0) continue;
      sum += straight * straight * exact_bits_exp(-(apart - 1.8) * (apart - 1.8) / 0.3);
    }
    return sum;
  }

  const Structure& structure_;
  AtomGraph graph_;
  const std::vector<Site>& sites_;
  Grouped<std::uint32_t> oxygens_;  ///< by site: O that its hydrogens may reach
  std::vector<PlacedHydrogen> placed_;
};

}  // namespace

bool is_backbone(const std::string& name) {
  return name == "N" || name == "CA" || name == "C" || name == "O" || name == "OXT";
}

std::vector<PlacedHydrogen> place_polar_hydrogens(const Structure& structure,
                                                  const Protonation& protonation) {
  const std::vector<Site> sites = SiteFinder(structure, protonation).find();
  return Placer(structure, sites).place();
}

}  // namespace pliant
