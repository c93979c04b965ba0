// SPDX-License-Identifier: MIT
// Strain of a small molecule: the energy of bonds, angles and torsions that leave their rest
// values, and of atoms that come near. Rest values are those of a structure, so that it needs no
// table of atom types. Torsions of bonds between sp3 atoms have the threefold barrier of UFF;
// others are held near where they are, but for those of rings beside one flat atom, which are free.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/conformers/rings/bond_chemistry.hpp"
#include "pliant/conformers/strain/dispersion.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

class Strain {
 public:
  /// Lengths and angles are at rest in `rest`, torsions in `held` (both N, Angstrom).
  Strain(const Framework& framework, const BondChemistry& chemistry, std::span<const Vec3> rest,
         std::span<const Vec3> held);

  /// kcal/mol at `x` (N, Angstrom); `gradient` (N) becomes its gradient, kcal/mol/Angstrom.
  double at(std::span<const Vec3> x, std::span<Vec3> gradient) const;

 private:
  struct Length {
    Joint a, b;
    double rest;  ///< Angstrom
  };
  struct Angle {
    Joint a, centre, b;
    double cosine, sine;  ///< at rest
  };
  /// stiffness (1 - cos(angle - rest)), or with a period of three and rest 180 degrees.
  struct Torsion {
    std::array<Joint, 4> at;
    double cosine, sine;  ///< at rest
    double stiffness;     ///< kcal/mol
    bool is_threefold;
  };

  void find_angles(const BondChemistry& chemistry, Joint centre, std::span<const Vec3> rest);
  void find_torsions(const BondChemistry& chemistry, Bar bond, std::span<const Vec3> held);
  double add_length(const Length& bond, std::span<const Vec3> x, std::span<Vec3> gradient) const;
  double add_angle(const Angle& angle, std::span<const Vec3> x, std::span<Vec3> gradient) const;
  double add_torsion(const Torsion& torsion, std::span<const Vec3> x,
                     std::span<Vec3> gradient) const;

  std::vector<Length> lengths_;
  std::vector<Angle> angles_;
  std::vector<Torsion> torsions_;
  Dispersion dispersion_;
};

}  // namespace pliant
