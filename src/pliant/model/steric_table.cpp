// SPDX-License-Identifier: MIT
#include "pliant/model/steric_table.hpp"

#include <array>
#include <vector>

#include "pliant/base/elements.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"

namespace pliant {
namespace {

enum Kind : std::uint16_t { C, N, NH, O, OH, S, H, HC, M, X, count };

constexpr std::array<std::string_view, count> names{"C", "N", "NH", "O", "OH",
                                                    "S", "H", "HC", "M", "X"};

// Angstrom. Those of C..O, S..S and of N and O without hydrogens are 0.02 more than where
// MolProbity's spheres (C 1.70, N 1.55, O 1.52, S 1.80) overlap by 0.4. NH and OH come nearer, as
// hydrogen bonds bring them; so does H to O. M leaves room for what holds a metal.
constexpr double table[count][count] = {
    //  C    N     NH   O     OH    S    H   HC    M    X
    {3.2, 2.9, 2.9, 2.84, 2.84, 3.2, 2.3, 2.4, 2.2, 2.6},   // C
    {2.9, 2.72, 2.6, 2.69, 2.6, 3.1, 2.3, 2.3, 1.7, 2.4},   // N
    {2.9, 2.6, 2.6, 2.6, 2.6, 3.1, 2.3, 2.3, 1.7, 2.4},     // NH
    {2.84, 2.69, 2.6, 2.66, 2.6, 3.0, 1.7, 2.2, 1.7, 2.4},  // O
    {2.84, 2.6, 2.6, 2.6, 2.6, 3.0, 1.7, 2.2, 1.7, 2.4},    // OH
    {3.2, 3.1, 3.1, 3.0, 3.0, 3.22, 2.4, 2.5, 2.0, 2.6},    // S
    {2.3, 2.3, 2.3, 1.7, 1.7, 2.4, 1.8, 1.9, 1.9, 1.8},     // H
    {2.4, 2.3, 2.3, 2.2, 2.2, 2.5, 1.9, 2.0, 1.9, 2.0},     // HC
    {2.2, 1.7, 1.7, 1.7, 1.7, 2.0, 1.9, 1.9, 2.4, 2.0},     // M
    {2.6, 2.4, 2.4, 2.4, 2.4, 2.6, 1.8, 2.0, 2.0, 2.4},     // X
};

// The row of HC where clashes count: spheres of 1.22 (HC), 1.70 (C), 1.55 (N), 1.40 (O) and 1.80
// (S) overlap by 0.38.
constexpr double careful[count] = {2.54, 2.39, 2.39, 2.24, 2.24, 2.64, 1.9, 2.06, 1.9, 2.0};

bool is_of_polymer(const Residue& residue) {
  return is_amino_acid(residue) || is_nucleotide(residue) || is_cap(residue);
}

bool counts_as_sulphur(std::uint8_t element) {
  constexpr std::array<std::uint8_t, 6> like{15, 16, 17, 34, 35, 53};  // P S Cl Se Br I
  for (std::uint8_t number : like)
    if (number == element) return true;
  return false;
}

/// (R) Whether N and O that have no hydrogen here have none indeed. It is not known of a ligand or
/// water whose hydrogens were all left out, nor of polymers if all of them lack them.
std::vector<bool> residues_with_known_hydrogens(const Structure& structure) {
  const AtomTable& atoms = structure.atoms;
  std::vector<bool> known(atoms.residues.size(), false);
  bool polymers_are_known = false;
  for (std::uint32_t atom = 0; atom < structure.size(); ++atom) {
    if (atoms.elements[atom] != 1) continue;
    const std::uint32_t residue = atoms.residue_of[atom];
    known[residue] = true;
    polymers_are_known = polymers_are_known || is_of_polymer(atoms.residues[residue]);
  }
  for (std::size_t r = 0; polymers_are_known && r < known.size(); ++r)
    if (is_of_polymer(atoms.residues[r])) known[r] = true;  // proline has no polar hydrogens
  return known;
}

class Kinds {
 public:
  explicit Kinds(const Structure& structure)
      : atoms_(structure.atoms),
        graph_(structure),
        is_known_(residues_with_known_hydrogens(structure)) {}

  Kind of(std::uint32_t atom) const {
    const std::uint8_t element = atoms_.elements[atom];
    if (element == 1) return of_hydrogen(atom);
    if (element == 6) return C;
    if (element == 7) return may_donate(atom) ? NH : N;
    if (element == 8) return may_donate(atom) ? OH : O;
    if (element == 9) return O;
    if (counts_as_sulphur(element)) return S;
    return is_metal(element) ? M : X;
  }

 private:
  Kind of_hydrogen(std::uint32_t atom) const {
    const std::uint32_t parent = graph_.first_heavy(atom);
    return parent != no_atom && atoms_.elements[parent] == 6 ? HC : H;
  }

  bool may_donate(std::uint32_t atom) const {
    return graph_.hydrogens_at(atom) > 0 || !is_known_[atoms_.residue_of[atom]];
  }

  const AtomTable& atoms_;
  AtomGraph graph_;
  std::vector<bool> is_known_;
};

}  // namespace

std::vector<std::string_view> steric_kind_names() { return {names.begin(), names.end()}; }

Sterics molecular_sterics(const Structure& structure, bool clashes_count) {
  const Kinds kinds(structure);
  Sterics sterics;
  sterics.kind_count = count;
  for (const auto& row : table) sterics.least.insert(sterics.least.end(), row, row + count);
  for (std::size_t kind = 0; clashes_count && kind < count; ++kind)
    sterics.least[std::size_t(HC) * count + kind] = sterics.least[kind * count + HC] =
        careful[kind];
  for (std::uint32_t atom = 0; atom < structure.size(); ++atom)
    sterics.kinds.push_back(kinds.of(atom));
  for (const Bond& bond : structure.bonds) sterics.bonds.emplace_back(bond.a, bond.b);
  return sterics;
}

}  // namespace pliant
