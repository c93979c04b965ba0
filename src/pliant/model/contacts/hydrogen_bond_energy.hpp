// SPDX-License-Identifier: MIT
// The energy of a hydrogen bond by Dahiyat, Gordon and Mayo (Protein Sci. 6 (1997) 1333) with the
// exponential of FIRST (Jacobs et al., Proteins 44 (2001) 150), and of a salt bridge.
//
//   E = 8 [5 (2.8/R)^12 - 6 (2.8/R)^10] F    kcal/mol, R = donor..acceptor in Angstrom
//   donor sp3, acceptor sp3: F = c cos^2(phi - 109.5 degrees)
//   donor sp3, acceptor sp2: F = c cos^2(phi)               with c = cos^2(theta) e^-(pi - theta)^6
//   donor sp2, acceptor sp3: F = c^2
//   donor sp2, acceptor sp2: F = c cos^2(max(phi, gamma))
//   theta = D-H..A, phi = H..A-B, gamma = angle of the planes at D and A, from 90 to 180 degrees
//   salt bridge: E = 10 [5 (3.2/(R + 0.375))^12 - 6 (3.2/(R + 0.375))^10]
#pragma once

#include <cstdint>

namespace pliant {

enum class Hybridisation : std::uint8_t { sp2, sp3 };

/// What the energy of a hydrogen bond follows from; angles in radians.
struct HydrogenBondGeometry {
  double donor_acceptor;  ///< Angstrom
  double theta, phi;
  double gamma;  ///< used between sp2 and sp2 only
  Hybridisation donor, acceptor;
};

/// kcal/mol, at most 0. A bond that is too short (E > 0, as X-ray structures have them) counts as
/// -4 F; below 2.3 Angstrom it is none, 0.
double hydrogen_bond_energy(const HydrogenBondGeometry& geometry);

/// kcal/mol, from -10 to 0; -8 where it is too short (E > 0), 0 below 2.2 Angstrom.
double salt_bridge_energy(double donor_acceptor);

}  // namespace pliant
