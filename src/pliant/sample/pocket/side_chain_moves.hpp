// SPDX-License-Identifier: MIT
// Side chains redrawn from rotamers: atoms turn about the bonds of a side chain, exact in every
// bar.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"
#include "pliant/sample/pocket/pocket.hpp"
#include "pliant/sample/pocket/rotamer_table.hpp"

namespace pliant {

/// A torsion beyond_a - a - b - beyond_b about a bond, and the joints that turn with it.
struct SideChainTorsion {
  Joint beyond_a, a, b, beyond_b;
  std::vector<Joint> turning;
};

struct SideChain {
  std::vector<SideChainTorsion> torsions;
  std::vector<std::span<const Rotamer>> rotamers;  ///< of torsions 0 with 1, 2, 3
  std::vector<Joint> surroundings;                 ///< that it may touch
};

class SideChainMoves {
 public:
  /// Side chains of a place that rotate freely: those bridged to others stay, and those of
  /// `residues_that_stay`. All must outlive it.
  SideChainMoves(const Framework& framework, const BodyPlan& plan, std::span<const Vec3> start,
                 const Pocket& place, std::span<const std::uint32_t> residues_that_stay = {});

  std::span<const SideChain> side_chains() const { return side_chains_; }

  /// Redraws each side chain of `x` (N, Angstrom) with probability `share`. One that overlaps with
  /// others in each of several draws stays. Several threads may call it at once.
  void redraw(RandomSequence& draws, double share, std::span<Vec3> x) const;
  /// The same, and each that overlaps with others is redrawn.
  void make_room(RandomSequence& draws, double share, std::span<Vec3> x) const;

 private:
  void redraw(const SideChain& side_chain, RandomSequence& draws, std::span<Vec3> x) const;
  void add(std::span<const Joint> atoms, std::string_view residue,
           std::span<const SideChainTorsion> turns);
  void find_surroundings(std::span<const Vec3> start, std::span<const Joint> ligand);
  bool fits(const SideChain& side_chain, std::span<const Vec3> x) const;

  std::optional<LeastDistances> rules_;
  std::vector<SideChain> side_chains_;
};

}  // namespace pliant
