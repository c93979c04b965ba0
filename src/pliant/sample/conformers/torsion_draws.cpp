// SPDX-License-Identifier: MIT
#include "pliant/sample/conformers/torsion_draws.hpp"

#include <bit>

namespace pliant {
namespace {

// Tangents of half of 6, 12, 20 and 25 degrees.
constexpr double within_6 = 0.052407779283041196, within_12 = 0.10510423526567646,
                 within_20 = 0.17632698070846498, within_25 = 0.22169466264293990;

constexpr Turn by_30{0.8660254037844386, 0.5};

template <class... Multiples>
constexpr std::uint16_t at(Multiples... multiples) {
  return static_cast<std::uint16_t>(((1u << multiples) | ...));
}

constexpr BondTurnEntry table[] = {
    {BondTurn::any, "any", 0xfff, within_6},
    {BondTurn::staggered, "staggered", at(2, 6, 10), within_12},
    {BondTurn::ester, "ester", 0, within_12},
    {BondTurn::in_plane, "in_plane", at(0, 6), within_20},
    {BondTurn::flanked, "flanked", at(0, 3, 6, 9), within_20},
    {BondTurn::near_plane, "near_plane", at(0, 1, 5, 6, 7, 11), within_12},
    {BondTurn::off_plane, "off_plane", at(1, 2, 3, 4, 5, 7, 8, 9, 10, 11), within_12},
    {BondTurn::flat_primary, "flat_primary", at(3, 9), within_25},
    {BondTurn::flat_branched, "flat_branched", at(2, 4, 8, 10), within_20},
    {BondTurn::beside_acyl, "beside_acyl", at(3, 6, 9), within_20}};

BondTurn from_flat(const BondChemistry& chemistry, Joint to) {
  if (chemistry.bonds_at(to).size() != 4) return BondTurn::any;
  const int heavy = chemistry.heavy_bonds_at(to);
  if (heavy == 2) return BondTurn::flat_primary;
  return heavy == 3 ? BondTurn::flat_branched : BondTurn::any;
}

/// Branches crowd about nitrogen in too many ways for one to be usual.
BondTurn from_nitrogen(const BondChemistry& chemistry, Joint to) {
  const BondTurn kind = from_flat(chemistry, to);
  return kind == BondTurn::flat_primary ? kind : BondTurn::any;
}

BondTurn aryl_nitrogen(const BondChemistry& chemistry, bool is_flanked, Joint to) {
  if (is_flanked) return BondTurn::off_plane;
  return chemistry.is_acylated(to) ? BondTurn::any : BondTurn::near_plane;
}

BondTurn from_aryl(const BondChemistry& chemistry, Joint aryl, Joint to) {
  const bool is_flanked = chemistry.is_flanked(aryl);
  if (chemistry.is_oxygen(to) && chemistry.bonds_at(to).size() == 2)
    return is_flanked ? BondTurn::flanked : BondTurn::in_plane;
  if (chemistry.is_nitrogen(to) && chemistry.bonds_at(to).size() == 3 && !chemistry.is_in_ring(to))
    return aryl_nitrogen(chemistry, is_flanked, to);
  if (chemistry.is_acyl(to)) return is_flanked ? BondTurn::any : BondTurn::near_plane;
  return from_flat(chemistry, to);
}

/// Nitrogen that bears no hydrogen, its bonds in a plane.
bool is_flat_nitrogen(const BondChemistry& chemistry, Joint atom) {
  return chemistry.is_nitrogen(atom) && chemistry.heavy_bonds_at(atom) == 3 &&
         chemistry.bonds_at(atom).size() == 3 && !chemistry.is_tetrahedral(atom);
}

}  // namespace

const BondTurnEntry& entry(BondTurn kind) { return table[static_cast<std::size_t>(kind)]; }

BondTurn turn_of(const BondChemistry& chemistry, Joint a, Joint b) {
  if (chemistry.is_ester(a, b) || chemistry.is_ester(b, a)) return BondTurn::ester;
  if (chemistry.is_aryl(a)) return from_aryl(chemistry, a, b);
  if (chemistry.is_aryl(b)) return from_aryl(chemistry, b, a);
  if (is_flat_nitrogen(chemistry, a)) return from_nitrogen(chemistry, b);
  if (is_flat_nitrogen(chemistry, b)) return from_nitrogen(chemistry, a);
  const bool both = chemistry.is_tetrahedral(a) && chemistry.is_tetrahedral(b);
  return both ? BondTurn::staggered : BondTurn::any;
}

BondTurn turn_in_loop(const BondChemistry& chemistry, Joint a, Joint b) {
  const BondTurn kind = turn_of(chemistry, a, b);
  if (kind == BondTurn::ester) return kind;
  const auto is_acylated = [&](Joint at) {
    return (chemistry.is_oxygen(at) || chemistry.is_nitrogen(at)) && chemistry.is_conjugated(at);
  };
  if ((is_acylated(a) && chemistry.bonds_at(b).size() == 4) ||
      (is_acylated(b) && chemistry.bonds_at(a).size() == 4))
    return BondTurn::beside_acyl;
  return kind;
}

Turn operator*(Turn one, Turn other) {
  return {one.cosine * other.cosine - one.sine * other.sine,
          one.sine * other.cosine + one.cosine * other.sine};
}

Turn of_half_tangent(double t) { return {(1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)}; }

Turn nearest_usual(Turn torsion, BondTurn kind) {
  if (kind == BondTurn::any) return torsion;
  const std::uint16_t multiples = entry(kind).multiples;
  Turn turn, nearest = torsion;
  double most = -2.0;
  for (int k = 0; k < 12; ++k, turn = turn * by_30) {
    const double cosine = turn.cosine * torsion.cosine + turn.sine * torsion.sine;
    if ((multiples >> k & 1) == 0 || cosine <= most) continue;
    most = cosine;
    nearest = turn;
  }
  return nearest;
}

Turn drawn_angle(RandomSequence& draws) {
  const Vec3 on_circle = draws.direction_in_plane();
  return {on_circle.x, on_circle.y};
}

/// Even but for the third order of the angle.
Turn drawn_jitter(RandomSequence& draws, BondTurn kind) {
  return of_half_tangent(entry(kind).half_tangent * (2.0 * draws.uniform() - 1.0));
}

Turn drawn_usual(RandomSequence& draws, BondTurn kind) {
  const std::uint16_t multiples = entry(kind).multiples;
  std::uint64_t left = draws.below(static_cast<std::uint64_t>(std::popcount(multiples)));
  Turn turn;
  for (int k = 0; k < 12; ++k, turn = turn * by_30)
    if ((multiples >> k & 1) != 0 && left-- == 0) break;
  return turn * drawn_jitter(draws, kind);
}

Turn drawn_in_loop(RandomSequence& draws, BondTurn kind) {
  if (kind != BondTurn::staggered || draws.below(4) != 0) return drawn_usual(draws, kind);
  return Turn{-1.0, 0.0} * drawn_jitter(draws, kind);
}

}  // namespace pliant
