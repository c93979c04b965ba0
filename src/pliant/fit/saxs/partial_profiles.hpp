// SPDX-License-Identifier: MIT
// The X-rays that a molecule in solution scatters at small angles: P. Debye, Ann. Phys. 351 (1915)
// 809, with the solvent that it displaces and a layer of water.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/fit/saxs/form_factors.hpp"

namespace pliant {

/// Pairs of amplitudes that are multiplied: v of the molecule in a vacuum, d of the solvent that it
/// displaces, w of water at its surface.
enum class Partial : std::uint8_t { vv, vd, dd, vw, dw, ww };
inline constexpr std::size_t partial_count = 6;

/// Profiles of a molecule whose groups move. Groups have amplitudes v and d (form_factors.hpp), and
/// w, the form factor of water times the share of the group that the solvent touches. The profile
/// of two amplitudes a, b is the sum over all i, j of a_i b_j sin(q r_ij) / (q r_ij), so that of
/// v - g d + c w is vv - 2 g vd + g^2 dd + 2 c vw - 2 g c dw + c^2 ww.
///
/// Distances are counted in bins of 0.05 Angstrom for each pair of kinds. Counts are integers:
/// their order does not matter. O(N^2).
class PartialProfiles {
 public:
  /// For groups no two of which are further apart than `longest` (Angstrom), at each q
  /// (1/Angstrom). Throws InputError for a distance that is above 20000 or not finite.
  PartialProfiles(std::span<const ScatteringGroup> groups, std::span<const double> q,
                  double longest);

  /// The profiles (6, K) in the order of Partial, electrons^2, of groups at `positions` (Angstrom).
  std::vector<double> of(std::span<const Vec3> positions) const;

 private:
  /// What all groups of an element with as many hydrogens have in common.
  struct Kind {
    std::size_t first, last;                ///< in order_
    std::vector<double> vacuum, displaced;  ///< (K) electrons
  };
  class Counter;

  void add_pairs(const Counter& counts, std::span<double> profiles) const;
  void add_layer(const Counter& counts, std::span<double> profiles) const;
  template <class Count>
  std::vector<double> transformed(std::span<const Count> counts) const;

  std::vector<ScatteringGroup> groups_;  ///< as given
  std::vector<std::uint32_t> order_;     ///< groups by their kinds
  std::vector<Kind> kinds_;
  std::size_t bins_, q_count_;
  std::vector<double> waves_;  ///< (bins, K) sin(q r) / (q r)
  std::vector<double> water_;  ///< (K) electrons, of one exposed point
};

}  // namespace pliant
