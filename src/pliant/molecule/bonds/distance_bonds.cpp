// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/distance_bonds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "pliant/base/elements.hpp"
#include "pliant/base/graphs/grouped.hpp"
#include "pliant/base/math/cell_list.hpp"
#include "pliant/molecule/bonds/valence.hpp"
#include "pliant/molecule/read/read.hpp"

namespace pliant::perception {
namespace {

// A cube as wide as a bond's cut-off, 2 to 4 Angstrom, holds less than 20 atoms of matter.
constexpr std::size_t most_in_a_cell = 100;

// No three-membered ring has an angle above this, 80 degrees; four-membered rings are just above.
constexpr double widest_ring_angle_cosine = 0.17364817766693033;

constexpr std::uint8_t hydrogen = 1, carbon = 6, oxygen = 8;

// H2 is 0.74 Angstrom long; two hydrogens further apart than this are two that touch.
constexpr double longest_hydrogen_molecule = 0.85;

// Bonds of hydrogen to elements beyond the second period are 0.95 to 1.1 of the sum of radii long
// (HCl 1.27, H2S 1.34, PH3 1.42, SiH4 1.48 Angstrom). What is much nearer is a placeholder.
constexpr double least_ratio_to_heavy = 0.85;
constexpr std::uint8_t neon = 10;

struct Candidate {
  double ratio;  ///< length / sum of radii
  std::uint32_t a, b;
  auto operator<=>(const Candidate&) const = default;
};

/// The atoms around each atom, over bonds and candidates.
class Neighbours {
 public:
  Neighbours(std::size_t atom_count, const std::vector<Bond>& bonds,
             const std::vector<Candidate>& candidates)
      : atoms_(atom_count, [&](const auto& put) {
          const auto join = [&](const auto& pair) {
            put(pair.a, pair.b);
            put(pair.b, pair.a);
          };
          for (const Bond& bond : bonds) join(bond);
          for (const Candidate& pair : candidates) join(pair);
        }) {}

  std::span<const std::uint32_t> of(std::uint32_t atom) const { return atoms_.at(atom); }

 private:
  Grouped<std::uint32_t, std::size_t> atoms_;
};

class DistanceStep {
 public:
  explicit DistanceStep(Perception& perception)
      : p_(perception), elements_(perception.structure.atoms.elements) {}

  void run() {
    choose_atoms();
    if (!anything_open_) return;
    count_known_bonds();
    collect_candidates();
    drop_ends_of_angles();
    drop_at_full_atoms();
    accept(heavy_);
    // Two hydrogens are a molecule only when neither has anything else to be bonded to.
    accept(hydrogen_pairs_);
  }

 private:
  /// Who can be bonded by distance: all but ions, waters, dummies and placeholders. Metals are ions
  /// unless they are in a residue of several atoms, which XYZ files do not tell apart.
  void choose_atoms() {
    water_.assign(p_.structure.size(), false);
    for (const ResiduePiece& piece : p_.pieces) {
      const bool water = piece.shape && piece.shape->kind == ResidueKind::water;
      if (water && is_settled(piece)) continue;
      for (std::uint32_t atom = piece.first; atom < piece.last; ++atom) {
        if (p_.excluded[atom] || !makes_bonds(atom, piece)) continue;
        water_[atom] = water;
        atoms_.push_back(atom);
        anything_open_ |= !p_.settled[atom];
      }
    }
  }

  bool is_settled(const ResiduePiece& piece) const {
    for (std::uint32_t atom = piece.first; atom < piece.last; ++atom)
      if (!p_.settled[atom]) return false;
    return true;
  }

  bool makes_bonds(std::uint32_t atom, const ResiduePiece& piece) const {
    const std::uint8_t element = elements_[atom];
    const bool is_alone = piece.last - piece.first == 1;
    if (covalent_radius(element) <= 0.0) return false;
    if (is_metal(element))
      return !is_alone && !is_always_ion(element) &&
             !is_from(p_.structure, &Format::has_bare_atoms);
    if (is_alone && is_halogen(element)) return false;
    return most_neighbours(element) > 0;
  }

  /// Bonds are sorted here: those of atom i as `a` are [first_bond_[i], first_bond_[i + 1]).
  void count_known_bonds() {
    neighbours_.assign(p_.structure.size(), 0);
    known_.assign(p_.structure.size(), {});
    first_bond_.assign(p_.structure.size() + 1, 0);
    for (const Bond& bond : p_.bonds) {
      ++first_bond_[bond.a + 1];
      ++neighbours_[bond.a];
      ++neighbours_[bond.b];
      if (is_metal(elements_[bond.a]) || is_metal(elements_[bond.b])) continue;
      for (std::uint32_t atom : {bond.a, bond.b}) known_[atom].add(bond);
    }
    for (std::size_t i = 0; i < p_.structure.size(); ++i) first_bond_[i + 1] += first_bond_[i];
  }

  bool is_known(std::uint32_t a, std::uint32_t b) const {
    for (std::size_t k = first_bond_[a]; k < first_bond_[a + 1]; ++k)
      if (p_.bonds[k].b == b) return true;
    return false;
  }

  /// Water is bonded to nothing else, least of all to other water.
  bool leaves_water(std::uint32_t a, std::uint32_t b) const {
    const auto& residue_of = p_.structure.atoms.residue_of;
    return (water_[a] || water_[b]) && residue_of[a] != residue_of[b];
  }

  /// Whether elements and residues allow a bond of this length, `ratio` to the sum of radii.
  bool is_possible(std::uint32_t a, std::uint32_t b, double length, double ratio) const {
    const auto [light, heavy] = std::minmax(elements_[a], elements_[b]);
    if (is_metal(light) || is_metal(heavy)) return is_of_complex(a, b);
    if (light != hydrogen || heavy == carbon) return true;
    if (heavy > neon) return ratio >= least_ratio_to_heavy;
    if (heavy != hydrogen) return true;
    const auto& residue_of = p_.structure.atoms.residue_of;
    return residue_of[a] == residue_of[b] && length <= longest_hydrogen_molecule;
  }

  bool is_full(std::uint32_t atom) const { return are_full(elements_[atom], known_[atom]); }

  /// Metals are bonded within their residue, but not to each other or to hydrogen.
  bool is_of_complex(std::uint32_t a, std::uint32_t b) const {
    const auto& residue_of = p_.structure.atoms.residue_of;
    return is_metal(elements_[a]) != is_metal(elements_[b]) && residue_of[a] == residue_of[b] &&
           std::min(elements_[a], elements_[b]) != hydrogen;
  }

  std::vector<Vec3> positions() const {
    std::vector<Vec3> points;
    points.reserve(atoms_.size());
    for (std::uint32_t atom : atoms_) points.push_back(p_.structure.positions[atom]);
    return points;
  }

  double largest_cutoff() const {
    double radius = 0.0;
    for (std::uint32_t atom : atoms_) radius = std::max(radius, covalent_radius(elements_[atom]));
    return 2.0 * radius + p_.options.slack;
  }

  CellList uncrowded_cells() {
    const double cutoff = largest_cutoff();
    CellList cells(positions(), cutoff);
    const std::vector<std::uint32_t> crowded = cells.points_in_cells_above(most_in_a_cell);
    if (crowded.empty()) return cells;
    for (std::uint32_t point : crowded) {
      p_.crowded.add([&] { return p_.structure.atoms.label(atoms_[point]); });
      atoms_[point] = none;
    }
    std::erase(atoms_, none);
    return CellList(positions(), cutoff);
  }

  void collect_candidates() {
    uncrowded_cells().for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
      const auto [a, b] = std::minmax(atoms_[i], atoms_[j]);
      if ((p_.settled[a] && p_.settled[b]) || leaves_water(a, b)) return;
      const double length = std::sqrt(squared);
      const double radii = covalent_radius(elements_[a]) + covalent_radius(elements_[b]);
      if (length <= p_.options.shortest || length > radii + p_.options.slack) return;
      if (is_known(a, b)) return;
      if (!is_possible(a, b, length, length / radii)) return;
      const bool hydrogens = elements_[a] == hydrogen && elements_[b] == hydrogen;
      (hydrogens ? hydrogen_pairs_ : heavy_).push_back({length / radii, a, b});
    });
  }

  /// Drops pairs that only look bonded because both are bonded to a third atom, as across the rings
  /// of cyclobutadiene, 1,3-dithietane and cyclodisiloxane.
  void drop_ends_of_angles() {
    const Neighbours neighbours(p_.structure.size(), p_.bonds, heavy_);
    std::erase_if(heavy_, [&](const Candidate& c) {
      const double length = p_.length(c.a, c.b);
      const auto around_b = neighbours.of(c.b);
      return std::ranges::any_of(neighbours.of(c.a), [&](std::uint32_t centre) {
        return elements_[centre] != hydrogen &&
               std::ranges::find(around_b, centre) != around_b.end() &&
               subtends_wide_angle(length, p_.length(centre, c.a), p_.length(centre, c.b));
      });
    });
  }

  /// Drops pairs at atoms that the bonds known before leave no place. After the ends of angles:
  /// what is dropped here still tells these apart, so that perceiving again adds nothing.
  void drop_at_full_atoms() {
    std::erase_if(heavy_, [&](const Candidate& c) {
      const auto [light, heavy] = std::minmax(elements_[c.a], elements_[c.b]);
      if (is_metal(light) || is_metal(heavy)) return false;
      if (light != hydrogen) return is_full(c.a) || is_full(c.b);
      return heavy == carbon && is_full(elements_[c.a] == carbon ? c.a : c.b);
    });
  }

  static bool subtends_wide_angle(double across, double leg, double other) {
    if (across <= std::max(leg, other)) return false;
    return leg * leg + other * other - across * across <
           2.0 * leg * other * widest_ring_angle_cosine;
  }

  /// A third neighbour of O is hydrogen (H3O+) or a metal.
  bool has_room(std::uint32_t atom, std::uint32_t other) const {
    if (neighbours_[atom] >= most_neighbours(elements_[atom])) return false;
    return elements_[atom] != oxygen || elements_[other] == hydrogen ||
           is_metal(elements_[other]) || known_[atom].neighbours < 2;
  }

  /// Bonds candidates from the shortest (against the radii) to the longest while both atoms have
  /// room. Only those at an atom with more candidates than room need to be in that order.
  void accept(std::vector<Candidate>& candidates) {
    std::vector<std::uint32_t> wanted(neighbours_);
    for (const Candidate& c : candidates) {
      ++wanted[c.a];
      ++wanted[c.b];
    }
    const auto has_room_for_all = [&](std::uint32_t atom) {
      return wanted[atom] <= (elements_[atom] == oxygen ? 2 : most_neighbours(elements_[atom]));
    };
    const auto is_free = [&](const Candidate& c) {
      return has_room_for_all(c.a) && has_room_for_all(c.b);
    };
    std::sort(std::partition(candidates.begin(), candidates.end(), is_free), candidates.end());
    for (const Candidate& c : candidates)
      if (has_room(c.a, c.b) && has_room(c.b, c.a)) add(c);
  }

  void add(const Candidate& c) {
    p_.add(c.a, c.b, BondOrigin::distance, 0);
    ++neighbours_[c.a];
    ++neighbours_[c.b];
    if (is_metal(elements_[c.a]) || is_metal(elements_[c.b])) return;
    ++known_[c.a].neighbours;
    ++known_[c.b].neighbours;
  }

  static constexpr std::uint32_t none = 0xffffffffU;
  Perception& p_;
  const std::vector<std::uint8_t>& elements_;
  std::vector<std::uint32_t> atoms_;       ///< that can be bonded by distance
  std::vector<bool> water_;                ///< (N) whether it is part of a water molecule
  bool anything_open_ = false;             ///< whether any of them is not settled
  std::vector<std::uint32_t> neighbours_;  ///< (N) bonds so far
  std::vector<KnownBonds> known_;          ///< (N) without metals; orders: of the steps before
  std::vector<std::size_t> first_bond_;
  std::vector<Candidate> heavy_, hydrogen_pairs_;
};

}  // namespace

void add_distance_bonds(Perception& perception) { DistanceStep(perception).run(); }

}  // namespace pliant::perception
