// SPDX-License-Identifier: MIT
// Sterics (excluded volume, hard spheres): least distances of joints that no bar joins.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace pliant {

/// A pair with its own least distance, which replaces the table's.
struct OwnDistance {
  std::uint32_t a = 0, b = 0;  ///< joints
  double least = 0.0;          ///< Angstrom; 0: no lower bound
  friend bool operator==(const OwnDistance&, const OwnDistance&) = default;
};

inline constexpr std::uint32_t no_unit = ~std::uint32_t{0};

/// Least distances by the kinds of two joints.
struct Sterics {
  std::size_t kind_count = 0;             ///< K
  std::vector<std::uint16_t> kinds = {};  ///< (N) kind of each joint, below K
  std::vector<double> least = {};         ///< (K * K) Angstrom, symmetric; 0: none
  std::vector<OwnDistance> own = {};      ///< pairs whose least distance is none of the above
  /// (N) joints with the same number never touch; may be empty
  std::vector<std::uint32_t> units = {};
  int excluded_bonds = 3;  ///< pairs up to this many bonds apart never touch; from 0
  /// Pairs of joints that count as bonds for excluded_bonds; empty: all bars.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> bonds = {};

  /// Least distance of two joints by their kinds alone (Angstrom).
  double of_kinds(std::uint32_t a, std::uint32_t b) const {
    return least[kinds[a] * kind_count + kinds[b]];
  }
  /// The largest least distance of any pair; 0 if there is none.
  double largest() const;
};

/// Throws InputError naming what is wrong: columns that differ in length, a kind that the table
/// does not have, a table that is not square or symmetric, a distance that is not from 0 to
/// 1e5 Angstrom, a joint that does not exist, a pair stated twice.
void check(const Sterics& sterics, std::size_t joint_count);

}  // namespace pliant
