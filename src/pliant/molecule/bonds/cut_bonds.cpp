// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/cut_bonds.hpp"

#include <cstdio>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/molecule/bonds/perception.hpp"
#include "pliant/molecule/bonds/template_bonds.hpp"

namespace pliant {
namespace {

/// The longer of two bonds, where its atoms have elements and the structure has its atoms.
void keep_longer(const Structure& structure, const Bond& bond, double& longest, Bond& kept) {
  const auto& elements = structure.atoms.elements;
  if (bond.a >= structure.size() || bond.b >= structure.size()) return;
  if (elements[bond.a] == 0 || elements[bond.b] == 0) return;
  const double length = distance(structure.positions[bond.a], structure.positions[bond.b]);
  if (!(length > longest)) return;
  longest = length;
  kept = bond;
}

[[noreturn]] void refuse(const Structure& structure, const Bond& bond, double length) {
  char text[48];
  std::snprintf(text, sizeof text, " is %.2f Angstrom long", length);
  std::string message =
      "bond " + structure.atoms.label(bond.a) + " - " + structure.atoms.label(bond.b) + text;
  message += structure.cell ? ", and the cell of the file does not make it shorter: the molecule "
                              "seems to be cut by another periodic box; "
                            : ": the molecule seems to be cut by a periodic box; ";
  message += "make it whole first (gmx trjconv -pbc whole)";
  if (!structure.cell) message += ", or give a file that states the box (CRYST1 of PDB)";
  throw InputError(structure.source.empty() ? message : at({structure.source}, message));
}

}  // namespace

void refuse_cut(const Structure& structure) {
  double longest = longest_bad_bond;
  Bond kept;
  for (const Bond& bond : structure.bonds) keep_longer(structure, bond, longest, kept);
  const BondOptions options;
  perception::Perception steps(structure, options);
  perception::add_template_bonds(steps);
  for (const Bond& bond : steps.stretched_bonds) keep_longer(structure, bond, longest, kept);
  if (longest > longest_bad_bond) refuse(structure, kept, longest);
}

}  // namespace pliant
