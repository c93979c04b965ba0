// SPDX-License-Identifier: MIT
// Hydrogen bonds and salt bridges, with the energy of Dahiyat, Gordon and Mayo (Protein Sci. 6
// (1997) 1333).
//
//   E = 8 [5 (2.8/R)^12 - 6 (2.8/R)^10] F    kcal/mol, R = donor..acceptor in Angstrom
//   donor sp3, acceptor sp3: F = c cos^2(phi - 109.5 degrees)     with c = cos^2(theta)
//   donor sp3, acceptor sp2: F = c cos^2(phi)                            exp(-(pi - theta)^6)
//   donor sp2, acceptor sp3: F = c^2
//   donor sp2, acceptor sp2: F = c cos^2(max(phi, gamma))
//   theta = D-H..A, phi = H..A-B, gamma = angle of the planes at D and A, from 90 to 180 degrees
//   salt bridge: E = 10 [5 (3.2/(R + 0.375))^12 - 6 (3.2/(R + 0.375))^10]
#pragma once

#include <vector>

#include "pliant/model/contact_list.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

enum class Hybridisation : std::uint8_t { sp2, sp3 };

/// What the energy of a hydrogen bond follows from; angles in radians.
struct HydrogenBondGeometry {
  double donor_acceptor;  ///< Angstrom
  double theta, phi;
  double gamma;  ///< used between sp2 and sp2 only
  Hybridisation donor, acceptor;
};

/// kcal/mol. A bond that is too short (E > 0, as X-ray structures have them) counts as -4 F.
double hydrogen_bond_energy(const HydrogenBondGeometry& geometry);

/// kcal/mol, -8 where it is too short.
double salt_bridge_energy(double donor_acceptor);

struct HydrogenBondOptions {
  double cutoff = -1.0;  ///< kcal/mol: bonds of no lower energy are left out
  ContactSlack slack = {};
};

/// The hydrogen bonds and salt bridges of a structure whose bonds are known and which has its polar
/// hydrogens: one bond a hydrogen (the best), one salt bridge a pair of donor and acceptor.
/// R <= 3.9, H..A <= 2.6 Angstrom, theta >= 100, phi >= 80 degrees; salt bridges R <= 4.6 Angstrom,
/// theta and phi >= 80 degrees. Donor and acceptor are more than two bonds apart. Sorted; linear in
/// the number of atoms.
std::vector<MolecularContact> hydrogen_bonds(const Structure& structure,
                                             const HydrogenBondOptions& options = {});

}  // namespace pliant
