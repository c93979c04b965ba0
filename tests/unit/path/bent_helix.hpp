// SPDX-License-Identifier: MIT
// A helix of 20 residues, and the same with a part turned about a bond of the backbone.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "pliant/base/math/best_fit.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/path/path.hpp"
#include "support/molecules.hpp"

namespace pliant::path_test {

inline Structure helix() { return test::bonded(molecule_file("peptide_20.pdb")); }

inline std::size_t atom_of(const Structure& s, std::uint32_t residue, const std::string& name) {
  for (std::size_t atom = 0; atom < s.size(); ++atom)
    if (s.atoms.residue_of[atom] == residue && s.atoms.names[atom] == name) return atom;
  throw std::runtime_error("no atom " + name);
}

/// What follows a residue (from 0) turned about the bond from one atom of it to another. `stays`
/// says of its own atoms which do not turn.
template <class Stays>
Structure bent_about(Structure s, std::uint32_t residue, const char* from, const char* to,
                     double degrees, Stays stays) {
  const Vec3 a = s.positions[atom_of(s, residue, from)], b = s.positions[atom_of(s, residue, to)];
  const Rotation turn =
      turn_about((1.0 / distance(a, b)) * (b - a), std::tan(degrees / 360.0 * std::numbers::pi));
  for (std::size_t atom = 0; atom < s.size(); ++atom)
    if (s.atoms.residue_of[atom] > residue ||
        (s.atoms.residue_of[atom] == residue && !stays(s.atoms.names[atom])))
      s.positions[atom] = a + turn(s.positions[atom] - a);
  return s;
}

/// About the bond N-CA.
inline Structure bent(const Structure& s, std::uint32_t residue, double degrees) {
  return bent_about(s, residue, "N", "CA", degrees, [](const std::string& name) {
    return name == "N" || name == "H" || name == "CA" || name == "HA";
  });
}

/// About the bond CA-C.
inline Structure bent_at_c(const Structure& s, std::uint32_t residue, double degrees) {
  return bent_about(s, residue, "CA", "C", degrees,
                    [](const std::string& name) { return name != "O"; });
}

inline double worst_bar(const MolecularPath& path) {
  double worst = 0.0;
  for (const std::vector<Vec3>& frame : path.positions)
    worst = std::max(worst, measure(path.ends->start.model.framework, frame).max_relative);
  return worst;
}

}  // namespace pliant::path_test
