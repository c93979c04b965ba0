// SPDX-License-Identifier: MIT
#include "pliant/model/steric_table.hpp"

#include <array>

#include "pliant/base/elements.hpp"
#include "pliant/model/atom_graph.hpp"

namespace pliant {
namespace {

enum Kind : std::uint16_t { C, N, O, S, H, HC, M, X, count };

constexpr std::array<std::string_view, count> names{"C", "N", "O", "S", "H", "HC", "M", "X"};

// Angstrom. C..O and S..S are 0.02 more than where MolProbity's spheres (C 1.70, O 1.52, S 1.80)
// overlap by 0.4. H..O leaves room for hydrogen bonds; M leaves room for what holds a metal.
constexpr double table[count][count] = {
    //  C    N    O    S    H   HC    M    X
    {3.2, 2.9, 2.84, 3.2, 2.3, 2.4, 2.2, 2.6},  // C
    {2.9, 2.6, 2.6, 3.1, 2.3, 2.3, 1.7, 2.4},   // N
    {2.84, 2.6, 2.6, 3.0, 1.7, 2.2, 1.7, 2.4},  // O
    {3.2, 3.1, 3.0, 3.22, 2.4, 2.5, 2.0, 2.6},  // S
    {2.3, 2.3, 1.7, 2.4, 1.8, 1.9, 1.9, 1.8},   // H
    {2.4, 2.3, 2.2, 2.5, 1.9, 2.0, 1.9, 2.0},   // HC
    {2.2, 1.7, 1.7, 2.0, 1.9, 1.9, 2.4, 2.0},   // M
    {2.6, 2.4, 2.4, 2.6, 1.8, 2.0, 2.0, 2.4},   // X
};

// The row of HC where clashes count: spheres of 1.22 (HC), 1.70 (C), 1.55 (N), 1.40 (O) and 1.80
// (S) overlap by 0.38.
constexpr double careful[count] = {2.54, 2.39, 2.24, 2.64, 1.9, 2.06, 1.9, 2.0};

bool counts_as_sulphur(std::uint8_t element) {
  constexpr std::array<std::uint8_t, 6> like{15, 16, 17, 34, 35, 53};  // P S Cl Se Br I
  for (std::uint8_t number : like)
    if (number == element) return true;
  return false;
}

Kind kind_of(const Structure& structure, const AtomGraph& graph, std::uint32_t atom) {
  const std::uint8_t element = structure.atoms.elements[atom];
  if (element == 6) return C;
  if (element == 7) return N;
  if (element == 8 || element == 9) return O;
  if (counts_as_sulphur(element)) return S;
  if (element == 1) {
    const std::uint32_t parent = graph.first_heavy(atom);
    return parent != no_atom && structure.atoms.elements[parent] == 6 ? HC : H;
  }
  return is_metal(element) ? M : X;
}

}  // namespace

std::vector<std::string_view> steric_kind_names() { return {names.begin(), names.end()}; }

Sterics molecular_sterics(const Structure& structure, bool clashes_count) {
  const AtomGraph graph(structure);
  Sterics sterics;
  sterics.kind_count = count;
  for (const auto& row : table) sterics.least.insert(sterics.least.end(), row, row + count);
  for (std::size_t kind = 0; clashes_count && kind < count; ++kind)
    sterics.least[HC * count + kind] = sterics.least[kind * count + HC] = careful[kind];
  for (std::uint32_t atom = 0; atom < structure.size(); ++atom)
    sterics.kinds.push_back(kind_of(structure, graph, atom));
  for (const Bond& bond : structure.bonds) sterics.bonds.emplace_back(bond.a, bond.b);
  return sterics;
}

}  // namespace pliant
