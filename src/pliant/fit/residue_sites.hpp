// SPDX-License-Identifier: MIT
// Where points of residues are, such as their mass or a label, as alpha carbons alone tell.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "pliant/fit/shape_terms.hpp"

namespace pliant {

/// A point that moves with a node and its neighbours along the chain: at x + a u + b v + c u x v,
/// where u and v lead from x, the node, to the next one and to the one before.
struct ResidueSite {
  std::uint32_t node = 0;
  bool has_frame = false;  ///< whether the node has both neighbours; else it is at the node
  double weight = 0.0;
  Vec3 local;  ///< a, b (of length 1) and c (1/Angstrom)
};

/// A point that moves with a node, at `arm` from it now.
ResidueSite residue_site(const FitNodes& nodes, std::uint32_t node, Vec3 arm, double weight = 1.0);

/// Points of a molecule, by its nodes.
class ResidueSites {
 public:
  /// Each `site` belongs to one of so many nodes.
  ResidueSites(std::size_t nodes, std::vector<ResidueSite> sites)
      : nodes_(nodes), sites_(std::move(sites)) {}

  /// Points of mass: one for each node, of all its atoms, or two: the mass of the atoms near to it
  /// (of a backbone), and of the others. `atoms` and `weights` are at the same time as the nodes;
  /// `node_of` says to which node an atom belongs.
  ResidueSites(const FitNodes& nodes, std::span<const Vec3> atoms, std::span<const double> weights,
               std::span<const std::uint32_t> node_of, std::size_t parts);

  std::size_t node_count() const { return nodes_; }
  std::size_t size() const { return sites_.size(); }
  double weight(std::size_t k) const { return sites_[k].weight; }
  std::vector<Vec3> places(std::span<const Vec3> nodes) const;
  /// Adds what a gradient by places (one for each site) is by nodes.
  void add_gradient(std::span<const Vec3> nodes, std::span<const Vec3> by_place,
                    std::span<Vec3> gradient) const;

 private:
  std::size_t nodes_;
  std::vector<ResidueSite> sites_;
};

}  // namespace pliant
