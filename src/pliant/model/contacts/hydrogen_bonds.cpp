// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/hydrogen_bonds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "pliant/base/math/elementary.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/near_atoms.hpp"
#include "pliant/model/contacts/hydrogen_bond_energy.hpp"
#include "pliant/model/contacts/polar_atoms.hpp"

namespace pliant {
namespace {

constexpr double pi = std::numbers::pi, degree = pi / 180.0;

/// How far apart and how bent a bond may be; Angstrom and radians.
struct Reach {
  double donor_acceptor, hydrogen_acceptor, least_theta, least_phi;
};
constexpr Reach usual_reach{3.9, 2.6, 100.0 * degree, 80.0 * degree};
// N and O of a salt bridge are within 4 Angstrom (Barlow, Thornton, J. Mol. Biol. 168 (1983) 867):
// one that is longer is broken by solvent, and would tie a flexible end to what does not move with
// it.
constexpr Reach salt_reach{4.0, 5.1, 80.0 * degree, 80.0 * degree};

/// The angle at `at`, between `one` and `other`; 0 to pi.
double angle(Vec3 one, Vec3 at, Vec3 other) {
  const Vec3 u = one - at, v = other - at;
  const double lengths = norm(u) * norm(v);
  if (!(lengths > 0.0)) return 0.0;
  return exact_bits_acos(std::clamp(dot(u, v) / lengths, -1.0, 1.0));
}

class Finder {
 public:
  Finder(const Structure& structure, const HydrogenBondOptions& options)
      : structure_(structure), options_(options), graph_(structure), polar_(structure, graph_) {}

  std::vector<MolecularContact> find() {
    const auto& hydrogens = polar_.hydrogens();
    std::vector<std::uint32_t> donors;  // once each
    for (std::uint32_t h : hydrogens) donors.push_back(graph_.first_heavy(h));
    std::sort(donors.begin(), donors.end());
    donors.erase(std::unique(donors.begin(), donors.end()), donors.end());
    const auto near = near_atoms(structure_, donors, polar_.acceptors(), salt_reach.donor_acceptor);
    for (std::size_t k = 0; k < donors.size(); ++k) add_bonds_of(donors[k], near.at(k));
    keep_best_of_pairs();
    add_bare_donors();
    sort(found_);
    return std::move(found_);
  }

 private:
  Vec3 at(std::uint32_t atom) const { return structure_.positions[atom]; }

  void add_bonds_of(std::uint32_t donor, std::span<const std::uint32_t> acceptors) {
    for (const Link& link : graph_.at(donor)) {
      if (!graph_.is_hydrogen(link.node)) continue;
      std::optional<MolecularContact> best;
      for (std::uint32_t acceptor : acceptors) {
        const std::optional<MolecularContact> bond =
            bond_of(donor, link.node, at(link.node), acceptor);
        if (!bond) continue;
        if (bond->kind == MolecularContactKind::salt_bridge) {
          found_.push_back(*bond);
        } else if (!best || bond->energy < best->energy) {
          best = bond;
        }
      }
      if (best) found_.push_back(*best);
    }
  }

  /// Those that molecules without hydrogens give to others: to atoms with which they have none yet.
  /// N of two neighbours that accepts a bond is taken to have no hydrogen.
  void add_bare_donors() {
    const BareDonors& bare = polar_.bare_donors();
    std::vector<bool> accepts(structure_.size(), false);
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const MolecularContact& one : found_) {
      accepts[one.b] = true;
      if (bare.contains(one.b)) pairs.emplace(one.b, one.a);
    }
    const auto near =
        near_atoms(structure_, bare.atoms(), polar_.acceptors(), usual_reach.donor_acceptor);
    for (std::size_t k = 0; k < bare.atoms().size(); ++k) {
      const std::uint32_t donor = bare.atoms()[k];
      if (accepts[donor] && graph_.at(donor).size() == 2) continue;
      std::vector<std::uint32_t> others;
      for (const std::uint32_t acceptor : near.at(k))
        if (!bare.contains(acceptor) && !pairs.contains({donor, acceptor}))
          others.push_back(acceptor);
      add_bare_bonds_of(donor, others);
    }
  }

  /// The best, as many as it has hydrogens.
  void add_bare_bonds_of(std::uint32_t donor, std::span<const std::uint32_t> acceptors) {
    const BareDonors& bare = polar_.bare_donors();
    std::vector<MolecularContact> bonds;
    for (const std::uint32_t acceptor : acceptors) {
      const Vec3 hydrogen = bare.hydrogen_towards(donor, at(acceptor));
      const auto bond = bond_of(donor, MolecularContact::none, hydrogen, acceptor);
      if (bond) bonds.push_back(*bond);
    }
    std::ranges::stable_sort(bonds, {}, &MolecularContact::energy);
    bonds.resize(std::min(bonds.size(), bare.hydrogens_of(donor)));
    found_.insert(found_.end(), bonds.begin(), bonds.end());
  }

  std::optional<MolecularContact> bond_of(std::uint32_t donor, std::uint32_t hydrogen, Vec3 place,
                                          std::uint32_t acceptor) const {
    if (graph_.are_within_two_bonds(donor, acceptor)) return std::nullopt;
    const std::uint32_t base = base_of(acceptor);
    if (base == no_atom) return std::nullopt;
    const bool is_salt = polar_.is_positive(donor) && polar_.is_negative(acceptor);
    const Reach& reach = is_salt ? salt_reach : usual_reach;
    const double apart = distance(at(donor), at(acceptor));
    const double theta = angle(at(donor), place, at(acceptor));
    const double phi = angle(place, at(acceptor), at(base));
    if (apart > reach.donor_acceptor || theta < reach.least_theta || phi < reach.least_phi ||
        distance(place, at(acceptor)) > reach.hydrogen_acceptor)
      return std::nullopt;
    MolecularContact bond;
    bond.kind = is_salt ? MolecularContactKind::salt_bridge : MolecularContactKind::hydrogen_bond;
    bond.a = donor;
    bond.b = acceptor;
    bond.hydrogen = hydrogen;
    if (hydrogen != MolecularContact::none) bond.base = base;
    bond.energy = is_salt ? salt_bridge_energy(apart) : energy(donor, acceptor, apart, theta, phi);
    if (!(bond.energy < options_.cutoff)) return std::nullopt;
    set_limits(bond, structure_);
    return bond;
  }

  double energy(std::uint32_t donor, std::uint32_t acceptor, double apart, double theta,
                double phi) const {
    HydrogenBondGeometry geometry{
        apart, theta, phi, 0.0, polar_.hybridisation(donor), polar_.hybridisation(acceptor)};
    const double alike = std::abs(dot(polar_.plane(donor), polar_.plane(acceptor)));
    geometry.gamma = pi - exact_bits_acos(std::clamp(alike, 0.0, 1.0));
    return hydrogen_bond_energy(geometry);
  }

  std::uint32_t base_of(std::uint32_t acceptor) const {
    const std::uint32_t heavy = graph_.first_heavy(acceptor);
    if (heavy != no_atom || graph_.at(acceptor).empty()) return heavy;
    return graph_.at(acceptor)[0].node;
  }

  /// A donor with several hydrogens reaches an acceptor by the best of them.
  void keep_best_of_pairs() {
    std::sort(found_.begin(), found_.end(), [](const auto& one, const auto& other) {
      return std::tie(one.a, one.b, one.energy, one.hydrogen) <
             std::tie(other.a, other.b, other.energy, other.hydrogen);
    });
    const auto same = [](const auto& one, const auto& other) {
      return one.a == other.a && one.b == other.b;
    };
    found_.erase(std::unique(found_.begin(), found_.end(), same), found_.end());
  }

  const Structure& structure_;
  const HydrogenBondOptions& options_;
  AtomGraph graph_;
  PolarAtoms polar_;
  std::vector<MolecularContact> found_;
};

}  // namespace

std::vector<MolecularContact> hydrogen_bonds(const Structure& structure,
                                             const HydrogenBondOptions& options) {
  return Finder(structure, options).find();
}

std::vector<MolecularContact> find_hydrogen_bonds(const Structure& structure,
                                                  const ContactOptions& options) {
  return hydrogen_bonds(structure, options.hydrogen_bonds);
}

}  // namespace pliant
