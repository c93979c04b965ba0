// SPDX-License-Identifier: MIT
// Ligands in a place: bonds that turn get other torsions, and the ligand is laid back on one of its
// rigid units, where that was. Exact in every bar.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/conformers/torsions/torsion_moves.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"

namespace pliant {

/// A ligand, or one of several.
struct LigandMolecule {
  std::vector<Joint> joints;
  std::vector<Rotor> rotors;
  std::vector<std::vector<Joint>> anchors;  ///< rigid units that it is laid on; none: it is bonded
                                            ///< to something else, and stays there
  std::vector<std::uint32_t> weights;       ///< (anchors) sums of their joints so far
  std::vector<Joint> surroundings;          ///< that it may touch, itself included
  std::vector<LimitIndex> contacts;         ///< limits between it and all else
};

class LigandMoves {
 public:
  /// `ligand`: its joints, whole residues; those without a bond that turns stay. `turns_away` (N):
  /// joints of side chains, which may make room. All must outlive it.
  LigandMoves(const Framework& framework, const BodyPlan& plan, std::span<const Vec3> start,
              std::span<const Joint> ligand, const BondChemistry& chemistry,
              std::vector<std::uint8_t> held, std::vector<bool> turns_away);

  std::span<const LigandMolecule> molecules() const { return molecules_; }

  /// Redraws some of the torsions of each ligand of `x` (N, Angstrom). One that overlaps with what
  /// cannot turn away, or tears a contact that is held, or all, in each of several draws stays.
  /// Returns whether one was redrawn. Several threads may call it at once.
  bool redraw(RandomSequence& draws, std::span<Vec3> x) const;

  /// Whether no ligand of `x` overlaps with anything.
  bool fits(std::span<const Vec3> x) const;

 private:
  struct RotorSearch {
    const BodyPlan& plan;
    const BondChemistry& chemistry;
    const std::vector<bool>& is_ligand;
    const std::vector<bool>& is_in_loop;
  };
  void find_rotors(const RotorSearch& in, const BodyTree& tree, LigandMolecule& found) const;
  void find_surroundings(LigandMolecule& molecule) const;
  void find_contacts(LigandMolecule& molecule) const;
  bool redraw(const LigandMolecule& molecule, RandomSequence& draws, std::span<Vec3> x) const;
  void lay_back(const LigandMolecule& molecule, RandomSequence& draws, std::span<const Vec3> before,
                std::span<Vec3> x) const;
  bool differs(const LigandMolecule& molecule, std::span<const Vec3> before,
               std::span<const Vec3> x) const;
  bool fits(const LigandMolecule& molecule, bool beside_all, std::span<const Vec3> x) const;
  bool holds(const LigandMolecule& molecule, std::span<const Vec3> x) const;

  const Framework& framework_;
  std::span<const Vec3> start_;
  std::vector<std::uint8_t> held_;
  std::vector<bool> turns_away_;
  std::optional<LeastDistances> rules_;
  std::vector<LigandMolecule> molecules_;
};

}  // namespace pliant
