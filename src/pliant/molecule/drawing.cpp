// SPDX-License-Identifier: MIT
#include "pliant/molecule/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/molecule/bond_lengths.hpp"

namespace pliant {
namespace {

// A bond of benzene, drawn with single and double bonds, is 0.14 Angstrom shorter than a single
// one.
constexpr double largest_deviation = 0.15;

// Lengths of one drawing differ by the rounding of its coordinates.
constexpr double same_length = 0.01;

constexpr std::uint8_t carbon = 6;

double length_of(const Structure& structure, const Bond& bond) {
  return distance(structure.positions[bond.a], structure.positions[bond.b]);
}

bool is_flat(const Structure& structure) {
  const auto& positions = structure.positions;
  return positions.size() > 3 &&
         std::all_of(positions.begin(), positions.end(), [](Vec3 p) { return p.z == 0.0; });
}

bool has_true_lengths(const Structure& structure) {
  const auto& elements = structure.atoms.elements;
  return std::all_of(structure.bonds.begin(), structure.bonds.end(), [&](const Bond& bond) {
    const auto standard = standard_bond_length(elements[bond.a], elements[bond.b], bond.order);
    return !standard || std::abs(length_of(structure, bond) - *standard) <= largest_deviation;
  });
}

/// Carbon with three single bonds or more and no other is a tetrahedron, unless it has a charge.
bool has_flat_tetrahedron(const Structure& structure) {
  std::vector<std::uint8_t> single(structure.size()), other(structure.size());
  for (const Bond& bond : structure.bonds)
    for (std::uint32_t atom : {bond.a, bond.b}) ++(bond.order == 1 ? single : other)[atom];
  for (std::size_t i = 0; i < structure.size(); ++i) {
    const bool is_neutral = structure.charges.empty() || structure.charges[i] == 0;
    const bool is_closed = structure.radicals.empty() || structure.radicals[i] == 0;
    if (structure.atoms.elements[i] == carbon && is_neutral && is_closed && single[i] >= 3 &&
        other[i] == 0)
      return true;
  }
  return false;
}

bool has_hydrogens(const Structure& structure) {
  const auto& elements = structure.atoms.elements;
  return std::find(elements.begin(), elements.end(), 1) != elements.end();
}

bool has_one_length(const Structure& structure) {
  const auto& bonds = structure.bonds;
  return std::all_of(bonds.begin(), bonds.end(), [&](const Bond& bond) {
    return std::abs(length_of(structure, bond) - length_of(structure, bonds[0])) <= same_length;
  });
}

}  // namespace

bool is_drawing(const Structure& structure) {
  if (!is_flat(structure) || structure.bonds.empty() || structure.dimensions == 3) return false;
  if (!has_true_lengths(structure) || has_flat_tetrahedron(structure)) return true;
  return structure.dimensions == 2 && !has_hydrogens(structure) && has_one_length(structure);
}

void refuse_drawing(const Structure& structure) {
  if (!is_drawing(structure)) return;
  const std::string problem = "this is a 2-D drawing (all z are 0): make it 3-D by RDKit: ";
  const std::string embed = "AllChem.EmbedMolecule(molecule, randomSeed=1)";
  const std::string& file = structure.source;
  if (file.empty()) throw InputError(problem + "molecule = Chem.AddHs(molecule); " + embed);
  throw InputError(at({file}, problem + "molecule = Chem.AddHs(Chem.MolFromMolFile(\"" + file +
                                  "\")); " + embed +
                                  "; Chem.MolToMolFile(molecule, \"three_d.sdf\")"));
}

}  // namespace pliant
