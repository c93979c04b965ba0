// SPDX-License-Identifier: MIT
// Elastic networks: springs between nodes, each of which represents a residue. A table of them;
// formulas and sources are in the README of this folder.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/base/math/dense_matrix.hpp"
#include "pliant/base/vec3.hpp"

namespace pliant {

inline constexpr std::uint32_t no_node = ~std::uint32_t{0};

/// Nodes of a network: one for each residue (alpha carbon), nucleotide or heavy atom of a ligand.
struct NetworkNodes {
  std::vector<Vec3> positions;          ///< (M) Angstrom
  std::vector<std::uint32_t> chain;     ///< (M) nodes of an unbroken chain are consecutive
  std::vector<std::uint32_t> of_joint;  ///< (N) node with which each joint moves, or no_node
  /// Factor of the cut-offs of springs: above 1 if a node represents several residues.
  double scale = 1.0;
};

/// Throws OptionError unless there are at least two nodes, each with a chain, and each joint's node
/// exists; InputError if a position is not finite.
void check(const NetworkNodes& nodes, std::size_t joint_count);

/// Spring constants between nodes. Those along the chain are separate, because cuts weaken only the
/// others.
struct Springs {
  DenseMatrix contacts;  ///< (M x M) symmetric, 0 on the diagonal; any unit
  DenseMatrix chain;     ///< (M x M) likewise
};

/// One row of the table of networks.
struct NetworkEntry {
  std::string_view name;
  std::string_view summary;
  /// Nodes move along springs only (anisotropic); otherwise equally in all directions.
  bool has_directions;
  /// The covariance is averaged over cuts into 1, 2, 3 and 4 domains.
  bool has_domains;
  Springs (*springs)(const NetworkNodes& nodes);
};

std::span<const NetworkEntry> networks();

/// The row of that name. Throws OptionError listing the known names.
const NetworkEntry& find_network(std::string_view name);

/// The matrix of second derivatives of the energy of springs k at rest: with directions (3M x 3M),
/// with blocks -k n n^T for n along the spring; otherwise (M x M), the Kirchhoff matrix.
DenseMatrix stiffness(std::span<const Vec3> positions, const DenseMatrix& springs,
                      bool has_directions);

/// The null space of stiffness(): shifts and turns of the whole (up to 6 x 3M), or shifts (1 x M),
/// in orthonormal rows.
DenseMatrix rigid_motions(std::span<const Vec3> positions, bool has_directions);

}  // namespace pliant
