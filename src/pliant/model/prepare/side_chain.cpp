// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/side_chain.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/hydrogen_places.hpp"

namespace pliant {
namespace {

constexpr std::string_view backbone[] = {"N", "CA", "C", "CB"};
constexpr std::size_t n = 0, ca = 1, c = 2, cb = 3, first_row = 4;

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

}  // namespace

SideChain::SideChain(const Structure& structure, const ResidueAtoms& residues,
                     std::uint32_t residue)
    : residue_(residue),
      rows_(side_chain_geometry(standard_name(structure.atoms.residues[residue].name))),
      turns_(usual_turns(standard_name(structure.atoms.residues[residue].name))),
      places_(first_row + rows_.size()),
      is_there_(first_row + rows_.size(), false) {
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const std::uint32_t atom = find(residues, k);
    is_there_[k] = atom != no_atom;
    if (is_there_[k]) places_[k] = structure.positions[atom];
  }
}

bool SideChain::can_be_built() const {
  if (!is_there_[n] || !is_there_[ca] || !is_there_[c]) return false;
  for (std::size_t k = 0; k < rows_.size(); ++k)
    if (is_there_[first_row + k] && !is_there_[number(rows_[k].parent)]) return false;
  return true;
}

std::vector<PlacedAtom> SideChain::placed(const SideChainTurns& turn) {
  std::vector<PlacedAtom> atoms;
  if (!is_there_[cb]) {
    places_[cb] = place_cb();
    atoms.push_back({places_[cb], 6});
  }
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    if (is_there_[first_row + k]) continue;
    places_[first_row + k] = place(rows_[k], turn);
    atoms.push_back({places_[first_row + k], rows_[k].element});
  }
  return atoms;
}

double SideChain::strain() const {
  if (!is_proline()) return 0.0;
  const Vec3 cd = places_.back();
  const double at_n = norm(cd - places_[n]) - n_cd, at_ca = norm(cd - places_[ca]) - ca_cd,
               at_cb = norm(cd - places_[cb]) - cb_cd;
  return at_n * at_n + at_ca * at_ca + 0.3 * at_cb * at_cb;
}

std::vector<std::string> SideChain::missing() const {
  std::vector<std::string> all;
  if (!is_there_[cb]) all.emplace_back("CB");
  for (std::size_t k = 0; k < rows_.size(); ++k)
    if (!is_there_[first_row + k]) all.emplace_back(rows_[k].name);
  return all;
}

std::uint32_t SideChain::find(const ResidueAtoms& residues, std::size_t k) const {
  if (k < first_row) return residues.find(residue_, backbone[k]);
  const SideChainAtom& row = rows_[k - first_row];
  const std::uint32_t atom = residues.find(residue_, row.name);
  const bool may_be_cd = atom == no_atom && row.residue == "ILE" && row.name == "CD1";
  return may_be_cd ? residues.find(residue_, "CD") : atom;
}

std::size_t SideChain::number(std::string_view name) const {
  const auto* const of_backbone = std::find(std::begin(backbone), std::end(backbone), name);
  if (of_backbone != std::end(backbone))
    return static_cast<std::size_t>(of_backbone - std::begin(backbone));
  const auto row = std::find_if(rows_.begin(), rows_.end(),
                                [&](const SideChainAtom& r) { return r.name == name; });
  return first_row + static_cast<std::size_t>(row - rows_.begin());
}

Vec3 SideChain::place(const SideChainAtom& row, const SideChainTurns& turn) const {
  const Vec3 neighbour = places_[number(row.neighbour)], parent = places_[number(row.parent)];
  const BondAngle angle = bond_angle(row.angle);
  if (const SideChainAtom* sibling = sibling_there(row))
    return Spin(places_[number(sibling->name)], neighbour, parent)
        .at(row.length, angle, -sibling->turn);
  const int turned = row.chi > 0 ? turn[row.chi - 1U] : int{row.turn};
  const Vec3 placed =
      Spin(places_[number(row.reference)], neighbour, parent).at(row.length, angle, turned);
  if (!is_proline() || row.name != "CD") return placed;
  return on_three_spheres({places_[n], n_cd}, {parent, cg_cd}, {places_[ca], ca_cd}, placed);
}

Vec3 SideChain::place_cb() const {
  if (!is_proline()) return ideal_cb(places_[n], places_[ca], places_[c]);
  return Spin(places_[c], places_[n], places_[ca]).at(1.53, bond_angle(103.1), -12);
}

/// An atom at the same parent that is placed by this one, and is there.
const SideChainAtom* SideChain::sibling_there(const SideChainAtom& row) const {
  if (row.chi == 0) return nullptr;
  for (std::size_t k = 0; k < rows_.size(); ++k)
    if (is_there_[first_row + k] && rows_[k].reference == row.name && rows_[k].parent == row.parent)
      return &rows_[k];
  return nullptr;
}

}  // namespace pliant
