// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/side_chain_geometry.hpp"

#include <algorithm>
#include <cstddef>

namespace pliant {
namespace {

constexpr SideChainAtom atoms[] = {
    {"ARG", "CG", "N", "CA", "CB", 6, 1.52, 114.1, 1, 0},
    {"ARG", "CD", "CA", "CB", "CG", 6, 1.52, 111.3, 2, 0},
    {"ARG", "NE", "CB", "CG", "CD", 7, 1.461, 112.0, 3, 0},
    {"ARG", "CZ", "CG", "CD", "NE", 6, 1.329, 124.2, 4, 0},
    {"ARG", "NH1", "CD", "NE", "CZ", 7, 1.326, 120.0, 0, 0},
    {"ARG", "NH2", "CD", "NE", "CZ", 7, 1.326, 119.7, 0, 18},
    {"ASN", "CG", "N", "CA", "CB", 6, 1.516, 112.6, 1, 0},
    {"ASN", "OD1", "CA", "CB", "CG", 8, 1.231, 120.8, 2, 0},
    {"ASN", "ND2", "OD1", "CB", "CG", 7, 1.328, 116.4, 0, 18},
    {"ASP", "CG", "N", "CA", "CB", 6, 1.516, 112.6, 1, 0},
    {"ASP", "OD1", "CA", "CB", "CG", 8, 1.249, 118.4, 2, 0},
    {"ASP", "OD2", "OD1", "CB", "CG", 8, 1.249, 118.4, 0, 18},
    {"CYS", "SG", "N", "CA", "CB", 16, 1.808, 114.4, 1, 0},
    {"GLN", "CG", "N", "CA", "CB", 6, 1.52, 114.1, 1, 0},
    {"GLN", "CD", "CA", "CB", "CG", 6, 1.516, 112.6, 2, 0},
    {"GLN", "OE1", "CB", "CG", "CD", 8, 1.231, 120.8, 3, 0},
    {"GLN", "NE2", "OE1", "CG", "CD", 7, 1.328, 116.4, 0, 18},
    {"GLU", "CG", "N", "CA", "CB", 6, 1.52, 114.1, 1, 0},
    {"GLU", "CD", "CA", "CB", "CG", 6, 1.516, 112.6, 2, 0},
    {"GLU", "OE1", "CB", "CG", "CD", 8, 1.249, 118.4, 3, 0},
    {"GLU", "OE2", "OE1", "CG", "CD", 8, 1.249, 118.4, 0, 18},
    {"HIS", "CG", "N", "CA", "CB", 6, 1.497, 113.8, 1, 0},
    {"HIS", "ND1", "CA", "CB", "CG", 7, 1.378, 122.7, 2, 0},
    {"HIS", "CD2", "ND1", "CB", "CG", 6, 1.356, 131.2, 0, 18},
    {"HIS", "CE1", "CB", "CG", "ND1", 6, 1.321, 109.0, 0, 18},
    {"HIS", "NE2", "CB", "CG", "CD2", 7, 1.374, 107.2, 0, 18},
    {"ILE", "CG1", "N", "CA", "CB", 6, 1.53, 110.4, 1, 0},
    {"ILE", "CG2", "CG1", "CA", "CB", 6, 1.521, 110.5, 0, -12},
    {"ILE", "CD1", "CA", "CB", "CG1", 6, 1.513, 113.8, 2, 0},
    {"LEU", "CG", "N", "CA", "CB", 6, 1.53, 116.3, 1, 0},
    {"LEU", "CD1", "CA", "CB", "CG", 6, 1.521, 110.7, 2, 0},
    {"LEU", "CD2", "CD1", "CB", "CG", 6, 1.521, 110.7, 0, 12},
    {"LYS", "CG", "N", "CA", "CB", 6, 1.52, 114.1, 1, 0},
    {"LYS", "CD", "CA", "CB", "CG", 6, 1.52, 111.3, 2, 0},
    {"LYS", "CE", "CB", "CG", "CD", 6, 1.52, 111.3, 3, 0},
    {"LYS", "NZ", "CG", "CD", "CE", 7, 1.489, 111.9, 4, 0},
    {"MET", "CG", "N", "CA", "CB", 6, 1.52, 114.1, 1, 0},
    {"MET", "SD", "CA", "CB", "CG", 16, 1.803, 112.7, 2, 0},
    {"MET", "CE", "CB", "CG", "SD", 6, 1.791, 100.9, 3, 0},
    {"PHE", "CG", "N", "CA", "CB", 6, 1.502, 113.8, 1, 0},
    {"PHE", "CD1", "CA", "CB", "CG", 6, 1.384, 120.7, 2, 0},
    {"PHE", "CD2", "CD1", "CB", "CG", 6, 1.384, 120.7, 0, 18},
    {"PHE", "CE1", "CB", "CG", "CD1", 6, 1.382, 120.7, 0, 18},
    {"PHE", "CE2", "CB", "CG", "CD2", 6, 1.382, 120.7, 0, 18},
    {"PHE", "CZ", "CG", "CD1", "CE1", 6, 1.382, 120.0, 0, 0},
    {"PRO", "CG", "N", "CA", "CB", 6, 1.492, 104.5, 1, 0},
    {"PRO", "CD", "CA", "CB", "CG", 6, 1.503, 106.1, 2, 0},
    {"SER", "OG", "N", "CA", "CB", 8, 1.417, 111.1, 1, 0},
    {"THR", "OG1", "N", "CA", "CB", 8, 1.433, 109.6, 1, 0},
    {"THR", "CG2", "OG1", "CA", "CB", 6, 1.521, 110.5, 0, -12},
    {"TRP", "CG", "N", "CA", "CB", 6, 1.498, 113.6, 1, 0},
    {"TRP", "CD1", "CA", "CB", "CG", 6, 1.365, 126.9, 2, 0},
    {"TRP", "CD2", "CD1", "CB", "CG", 6, 1.433, 126.8, 0, 18},
    {"TRP", "NE1", "CB", "CG", "CD1", 7, 1.374, 110.2, 0, 18},
    {"TRP", "CE2", "CB", "CG", "CD2", 6, 1.409, 107.2, 0, 18},
    {"TRP", "CE3", "CB", "CG", "CD2", 6, 1.398, 133.9, 0, 0},
    {"TRP", "CZ2", "CG", "CD2", "CE2", 6, 1.394, 122.4, 0, 18},
    {"TRP", "CZ3", "CG", "CD2", "CE3", 6, 1.382, 118.6, 0, 18},
    {"TRP", "CH2", "CD2", "CE2", "CZ2", 6, 1.368, 117.5, 0, 0},
    {"TYR", "CG", "N", "CA", "CB", 6, 1.512, 113.9, 1, 0},
    {"TYR", "CD1", "CA", "CB", "CG", 6, 1.389, 120.8, 2, 0},
    {"TYR", "CD2", "CD1", "CB", "CG", 6, 1.389, 120.8, 0, 18},
    {"TYR", "CE1", "CB", "CG", "CD1", 6, 1.382, 121.2, 0, 18},
    {"TYR", "CE2", "CB", "CG", "CD2", 6, 1.382, 121.2, 0, 18},
    {"TYR", "CZ", "CG", "CD1", "CE1", 6, 1.378, 119.6, 0, 0},
    {"TYR", "OH", "CD1", "CE1", "CZ", 8, 1.376, 119.9, 0, 18},
    {"VAL", "CG1", "N", "CA", "CB", 6, 1.521, 110.5, 1, 0},
    {"VAL", "CG2", "CG1", "CA", "CB", 6, 1.521, 110.5, 0, 12},
};

constexpr RingBond rings[] = {{"HIS", "CE1", "NE2"}, {"PHE", "CE2", "CZ"},  {"PRO", "CD", "N"},
                              {"TRP", "CE2", "NE1"}, {"TRP", "CH2", "CZ3"}, {"TYR", "CE2", "CZ"}};

constexpr SideChainTurns staggered[] = {{-6}, {18}, {6}};  // and CYS
constexpr SideChainTurns valine[] = {{18}, {-6}, {6}};
constexpr SideChainTurns serine[] = {{6}, {-6}, {18}};
constexpr SideChainTurns proline[] = {{3, -4}, {-3, 4}, {2, -3}, {-2, 3},
                                      {4, -4}, {-4, 4}, {1, -1}, {-1, 1}};
constexpr SideChainTurns leucine[] = {{-6, 18}, {18, 6}, {18, 15}, {-9, 6}, {6, 8}};
constexpr SideChainTurns isoleucine[] = {{-6, 17}, {6, 17}, {-6, -6}, {18, 17}, {18, 6}};
constexpr SideChainTurns aromatic[] = {{-6, -9}, {18, 8}, {6, 9}, {-6, -3}};
constexpr SideChainTurns tryptophan[] = {{-6, 10}, {18, -10}, {6, -9}, {18, 9},
                                         {-6, 0},  {6, 9},    {-6, -9}};
constexpr SideChainTurns histidine[] = {{-6, -7}, {18, 6}, {-6, 8}, {18, -8},
                                        {-6, 17}, {6, 8},  {6, -8}, {18, -17}};
constexpr SideChainTurns aspartate[] = {{-7, -2}, {18, 0}, {6, -1}, {6, 3}, {18, 7}};
constexpr SideChainTurns asparagine[] = {{-7, -2}, {18, 3},  {18, -2}, {6, -1},
                                         {6, 3},   {-7, -8}, {-7, 12}};

/// All of some choices for each torsion, the last changing first.
template <std::size_t... Counts>
constexpr auto product(const std::int8_t (&... choices)[Counts]) {
  std::array<SideChainTurns, (Counts * ...)> all{};
  const std::int8_t* const lists[] = {choices...};
  const std::size_t counts[] = {Counts...};
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::size_t rest = k;
    for (std::size_t i = sizeof...(Counts); i-- > 0; rest /= counts[i])
      all[k][i] = lists[i][rest % counts[i]];
  }
  return all;
}

constexpr std::int8_t chi1[] = {-6, 18, 6}, anti[] = {18, -6, 6}, wide[] = {18, 9, -9},
                      acid[] = {0, -3, 3}, amide[] = {0, -4, 4, 9, -9};
constexpr auto methionine = product(chi1, anti, anti);
constexpr auto lysine = product(chi1, anti, anti, anti);
constexpr auto arginine = product(chi1, anti, anti, wide);
constexpr auto glutamate = product(chi1, anti, acid);
constexpr auto glutamine = product(chi1, anti, amide);

struct Turns {
  std::string_view residue;
  std::span<const SideChainTurns> turns;
};
constexpr Turns turns[] = {
    {"ARG", arginine},  {"ASN", asparagine}, {"ASP", aspartate},  {"CYS", staggered},
    {"GLN", glutamine}, {"GLU", glutamate},  {"HIS", histidine},  {"ILE", isoleucine},
    {"LEU", leucine},   {"LYS", lysine},     {"MET", methionine}, {"PHE", aromatic},
    {"PRO", proline},   {"SER", serine},     {"THR", serine},     {"TRP", tryptophan},
    {"TYR", aromatic},  {"VAL", valine},
};

}  // namespace

std::span<const SideChainAtom> side_chain_geometry(std::string_view standard) {
  const auto is_of = [&](const SideChainAtom& row) { return row.residue == standard; };
  const auto* const first = std::find_if(std::begin(atoms), std::end(atoms), is_of);
  return {first, std::find_if_not(first, std::end(atoms), is_of)};
}

// Coefficients for a tetrahedral CA.
Vec3 ideal_cb(Vec3 n, Vec3 ca, Vec3 c) {
  const Vec3 b = ca - n, d = c - ca;
  const Vec3 along = -0.58273431 * cross(b, d) + 0.56802827 * b - 0.54067466 * d;
  return ca + (1.53 / norm(along)) * along;
}

std::span<const RingBond> ring_bonds() { return rings; }

std::span<const SideChainTurns> usual_turns(std::string_view standard) {
  for (const Turns& row : turns)
    if (row.residue == standard) return row.turns;
  return {};
}

}  // namespace pliant
