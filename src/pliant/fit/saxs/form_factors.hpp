// SPDX-License-Identifier: MIT
// How X-rays are scattered by a heavy atom with its hydrogens.
#pragma once

#include <compare>
#include <cstdint>

namespace pliant {

/// A heavy atom and the hydrogens bonded to it, at the place of the heavy atom.
struct ScatteringGroup {
  std::uint8_t element = 6;
  std::uint8_t hydrogens = 0;
  friend auto operator<=>(const ScatteringGroup&, const ScatteringGroup&) = default;
};

/// sin(q r) / (q r): what two points at a distance r (Angstrom) scatter together, averaged over all
/// directions; q in 1/Angstrom.
double wave_between(double q, double distance);

/// Form factor of an atom in a vacuum, electrons, at q = 4 pi sin(theta) / lambda (1/Angstrom):
/// sums of Gaussians of International Tables C (1992), table 6.1.1.4. An element that is not in our
/// table has the curve of the nearest that is, by its number of electrons.
double atom_form_factor(std::uint8_t element, double q);

/// Form factor of a group: hydrogens add theirs, averaged over the directions of their bonds.
double form_factor(ScatteringGroup group, double q);

/// Form factor of a water molecule at its oxygen.
double water_form_factor(double q);

/// Volume of solvent that a group displaces, Angstrom^3: the sum of its atoms (R. Fraser,
/// T. MacRae, E. Suzuki, J. Appl. Cryst. 11 (1978) 693; D. Svergun, C. Barberato, M. Koch, ibid. 28
/// (1995) 768). Elements without a volume of their own have that of manganese, 9.2.
double displaced_volume(ScatteringGroup group);

/// Form factor of water of a volume (Angstrom^3), 0.334 electrons per Angstrom^3, as a Gaussian
/// sphere.
double displaced_form_factor(double volume, double q);

}  // namespace pliant
