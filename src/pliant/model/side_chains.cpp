// SPDX-License-Identifier: MIT
#include "pliant/model/side_chains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "pliant/base/grouped.hpp"
#include "pliant/model/hydrogen_places.hpp"
#include "pliant/model/near_atoms.hpp"
#include "pliant/model/residue_chemistry.hpp"
#include "pliant/model/side_chain_geometry.hpp"

namespace pliant {
namespace {

/// From CA to the last atom of ARG, and a contact beyond it.
constexpr double reach_of_atoms = 11.0, reach_of_side_chains = 19.0;

constexpr std::string_view backbone[] = {"N", "CA", "C", "CB"};
constexpr std::size_t n = 0, ca = 1, c = 2, cb = 3, first_row = 4;

/// Nearer than this two atoms overlap, Angstrom (see steric_table.hpp; hydrogen: with any).
double least_distance(std::uint8_t one, std::uint8_t other) {
  const auto is_polar = [](std::uint8_t element) { return element == 7 || element == 8; };
  if (one == 1 || other == 1) return 2.3;
  return is_polar(one) && is_polar(other) ? 2.7 : 3.2;
}

/// cos and sin of an angle, the same bits everywhere: cos(90 + x) = -sin x by Taylor's series.
BondAngle bond_angle(double degrees) {
  const double x = (degrees - 90.0) * 0.017453292519943295;
  double term = x, sine = x;
  for (int k = 1; k <= 10; ++k) {
    term *= -x * x / (2.0 * k * (2.0 * k + 1.0));
    sine += term;
  }
  return {-sine, std::sqrt(1.0 - sine * sine)};
}

/// A centre, and how far from it a point is, Angstrom.
struct Sphere {
  Vec3 centre;
  double radius;
};

/// The point on three spheres that is nearer to `guess`; the guess if there is none.
Vec3 on_three_spheres(const Sphere& one, const Sphere& two, const Sphere& three, Vec3 guess) {
  const Vec3 x = unit_vector(two.centre - one.centre), to_three = three.centre - one.centre;
  const double apart = norm(two.centre - one.centre), i = dot(x, to_three);
  const Vec3 y = unit_vector(to_three - i * x), z = cross(x, y);
  const double j = dot(y, to_three), r = one.radius * one.radius;
  const double along = (r - two.radius * two.radius + apart * apart) / (2.0 * apart);
  const double aside =
      (r - three.radius * three.radius + i * i + j * j) / (2.0 * j) - i / j * along;
  const double above = r - along * along - aside * aside;
  if (!(above >= 0.0)) return guess;
  const Vec3 foot = one.centre + along * x + aside * y;
  const double side = dot(guess - foot, z) < 0.0 ? -1.0 : 1.0;
  return foot + side * std::sqrt(above) * z;
}

// Proline's CD closes its ring: so far from N, CG and CA (112 degrees at N); from CB (106.1 degrees
// at CG) as puckering allows, Angstrom.
constexpr double n_cd = 1.473, cg_cd = 1.503, ca_cd = 2.437, cb_cd = 2.393;

// Angstrom^2: what a ring that does not close costs, beside squared overlaps.
constexpr double cost_of_strain = 100.0;

struct Atom {
  Vec3 position;
  std::uint8_t element;
};

/// A residue whose side chain is not whole: where its atoms are, and how the missing are placed.
class SideChain {
 public:
  SideChain(const Structure& structure, const ResidueAtoms& residues, std::uint32_t residue)
      : residue(residue),
        rows(side_chain_geometry(standard_name(structure.atoms.residues[residue].name))),
        turns(usual_turns(standard_name(structure.atoms.residues[residue].name))),
        places_(first_row + rows.size()),
        is_there_(first_row + rows.size(), false) {
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const std::uint32_t atom = find(residues, k);
      is_there_[k] = atom != no_atom;
      if (is_there_[k]) places_[k] = structure.positions[atom];
    }
  }

  /// Whether the backbone is there, and no atom is missing between others.
  bool can_be_built() const {
    if (!is_there_[n] || !is_there_[ca] || !is_there_[c]) return false;
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (is_there_[first_row + k] && !is_there_[number(rows[k].parent)]) return false;
    return true;
  }

  /// The missing atoms with torsions `turn`, in the order of names().
  std::vector<Atom> placed(const SideChainTurns& turn) {
    std::vector<Atom> atoms;
    if (!is_there_[cb]) {
      places_[cb] = place_cb();
      atoms.push_back({places_[cb], 6});
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (is_there_[first_row + k]) continue;
      places_[first_row + k] = place(rows[k], turn);
      atoms.push_back({places_[first_row + k], rows[k].element});
    }
    return atoms;
  }

  bool is_proline() const { return !rows.empty() && rows.front().residue == "PRO"; }

  /// How far the ring of proline is from closed as it was placed last: squared, Angstrom^2.
  double strain() const {
    if (!is_proline()) return 0.0;
    const Vec3 cd = places_.back();
    const double at_n = norm(cd - places_[n]) - n_cd, at_ca = norm(cd - places_[ca]) - ca_cd,
                 at_cb = norm(cd - places_[cb]) - cb_cd;
    return at_n * at_n + at_ca * at_ca + 0.3 * at_cb * at_cb;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    if (!is_there_[cb]) all.emplace_back("CB");
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (!is_there_[first_row + k]) all.emplace_back(rows[k].name);
    return all;
  }

  std::uint32_t residue;
  std::span<const SideChainAtom> rows;
  std::span<const SideChainTurns> turns;
  std::vector<Atom> chosen = {};
  double overlap = 0.0;

 private:
  std::uint32_t find(const ResidueAtoms& residues, std::size_t k) const {
    if (k < first_row) return residues.find(residue, backbone[k]);
    const SideChainAtom& row = rows[k - first_row];
    const std::uint32_t atom = residues.find(residue, row.name);
    const bool may_be_cd = atom == no_atom && row.residue == "ILE" && row.name == "CD1";
    return may_be_cd ? residues.find(residue, "CD") : atom;
  }

  std::size_t number(std::string_view name) const {
    const auto* const of_backbone = std::find(std::begin(backbone), std::end(backbone), name);
    if (of_backbone != std::end(backbone))
      return static_cast<std::size_t>(of_backbone - std::begin(backbone));
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const SideChainAtom& r) { return r.name == name; });
    return first_row + static_cast<std::size_t>(row - rows.begin());
  }

  Vec3 place(const SideChainAtom& row, const SideChainTurns& turn) const {
    const Vec3 neighbour = places_[number(row.neighbour)], parent = places_[number(row.parent)];
    const BondAngle angle = bond_angle(row.angle);
    if (const SideChainAtom* sibling = sibling_there(row))
      return Spin(places_[number(sibling->name)], neighbour, parent)
          .at(row.length, angle, -sibling->turn);
    const int turned = row.chi > 0 ? turn[row.chi - 1U] : row.turn;
    const Vec3 placed =
        Spin(places_[number(row.reference)], neighbour, parent).at(row.length, angle, turned);
    if (!is_proline() || row.name != "CD") return placed;
    return on_three_spheres({places_[n], n_cd}, {parent, cg_cd}, {places_[ca], ca_cd}, placed);
  }

  Vec3 place_cb() const {
    if (!is_proline()) return ideal_cb(places_[n], places_[ca], places_[c]);
    return Spin(places_[c], places_[n], places_[ca]).at(1.53, bond_angle(103.1), -12);
  }

  /// An atom at the same parent that is placed by this one, and is there.
  const SideChainAtom* sibling_there(const SideChainAtom& row) const {
    if (row.chi == 0) return nullptr;
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (is_there_[first_row + k] && rows[k].reference == row.name && rows[k].parent == row.parent)
        return &rows[k];
    return nullptr;
  }

  std::vector<Vec3> places_;  ///< N, CA, C, CB, then rows
  std::vector<bool> is_there_;
};

/// Chooses torsions of all side chains that are not whole.
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
      for (std::size_t k = 0; k < side_chains_.size(); ++k) choose(k);
    std::vector<NewAtom> added;
    for (SideChain& side_chain : side_chains_) add(side_chain, added);
    result_.edited = with_atoms(structure_, added);
    join();
    return std::move(result_);
  }

 private:
  void look_at(std::uint32_t residue) {
    SideChain side_chain(structure_, residues_, residue);
    if (side_chain.names().empty()) return;
    if (!side_chain.can_be_built()) return result_.left.push_back(residue);
    side_chains_.push_back(std::move(side_chain));
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

  /// Not what bonds bring near: its own residue but O, and what proline's N binds.
  bool may_run_into(const SideChain& side_chain, std::uint32_t atom) const {
    const std::uint32_t residue = structure_.atoms.residue_of[atom];
    const std::string& name = structure_.atoms.names[atom];
    if (residue == side_chain.residue) return name == "O";
    const bool is_before = residue + 1 == side_chain.residue;
    return !(is_before && side_chain.is_proline() && (name == "C" || name == "O" || name == "CA"));
  }

  /// Atoms that the side chain should keep away from.
  std::vector<Atom> others(std::size_t k) const {
    std::vector<Atom> found;
    for (std::uint32_t atom : atoms_near_.at(k))
      if (may_run_into(side_chains_[k], atom))
        found.push_back({structure_.positions[atom], structure_.atoms.elements[atom]});
    for (std::uint32_t other : side_chains_near_.at(k))
      found.insert(found.end(), side_chains_[other].chosen.begin(),
                   side_chains_[other].chosen.end());
    return found;
  }

  /// The first of the usual torsions with the least sum of squared overlaps.
  void choose(std::size_t k) {
    SideChain& side_chain = side_chains_[k];
    const std::vector<Atom> surroundings = others(k);
    double least = std::numeric_limits<double>::infinity();
    const SideChainTurns none[] = {{}};
    for (const SideChainTurns& turn : side_chain.turns.empty() ? none : side_chain.turns) {
      const std::vector<Atom> atoms = side_chain.placed(turn);
      const auto [overlaps, deepest] = overlap_of(atoms, surroundings);
      const double sum = overlaps + cost_of_strain * side_chain.strain();
      if (sum >= least) continue;
      least = sum;
      side_chain.chosen = atoms;
      side_chain.overlap = deepest;
      if (sum == 0.0) return;
    }
  }

  /// Sum of squares, and the deepest.
  static std::pair<double, double> overlap_of(const std::vector<Atom>& atoms,
                                              const std::vector<Atom>& others) {
    double sum = 0.0, deepest = 0.0;
    for (const Atom& atom : atoms)
      for (const Atom& other : others) {
        const double limit = least_distance(atom.element, other.element);
        const double squared = norm_squared(atom.position - other.position);
        if (squared >= limit * limit) continue;
        const double depth = limit - std::sqrt(squared);
        sum += depth * depth;
        deepest = std::max(deepest, depth);
      }
    return {sum, deepest};
  }

  void add(const SideChain& side_chain, std::vector<NewAtom>& added) {
    const std::vector<std::string> names = side_chain.names();
    std::string listed;
    for (std::size_t k = 0; k < names.size(); ++k) {
      added.push_back({residues_.find(side_chain.residue, "CA"), names[k],
                       side_chain.chosen[k].element, side_chain.chosen[k].position, false});
      listed += (listed.empty() ? "" : " ") + names[k];
    }
    result_.built.push_back({side_chain.residue, listed, side_chain.overlap});
  }

  /// Bonds of the atoms that were built.
  void join() {
    Structure& whole = result_.edited.structure;
    const ResidueAtoms residues(whole.atoms);
    for (const SideChain& side_chain : side_chains_) {
      const auto join_two = [&](std::string_view one, std::string_view other) {
        const std::uint32_t a = residues.find(side_chain.residue, one),
                            b = residues.find(side_chain.residue, other);
        if (a == no_atom || b == no_atom) return;  // CD1 of ILE may be called CD
        const bool is_new =
            result_.edited.origin[a] == no_atom || result_.edited.origin[b] == no_atom;
        if (is_new) whole.bonds.push_back({std::min(a, b), std::max(a, b), BondOrigin::residue, 1});
      };
      join_two("CA", "CB");
      for (const SideChainAtom& row : side_chain.rows) join_two(row.parent, row.name);
      for (const RingBond& ring : ring_bonds())
        if (!side_chain.rows.empty() && ring.residue == side_chain.rows.front().residue)
          join_two(ring.one, ring.other);
    }
    std::sort(whole.bonds.begin(), whole.bonds.end(), [](const Bond& one, const Bond& other) {
      return std::pair(one.a, one.b) < std::pair(other.a, other.b);
    });
  }

  const Structure& structure_;
  ResidueAtoms residues_;
  std::vector<SideChain> side_chains_;
  std::vector<std::uint32_t> centres_;  ///< CA of each
  Grouped<std::uint32_t> atoms_near_, side_chains_near_;
  BuiltSideChains result_;
};

}  // namespace

BuiltSideChains build_side_chains(const Structure& structure) { return Builder(structure).build(); }

}  // namespace pliant
