// SPDX-License-Identifier: MIT
// Dilution: hydrogen bonds are taken out one by one, the weakest first, and rigid clusters break up
// (simulated thermal unfolding; Hespenheide, Rader, Thorpe, Kuhn, J. Mol. Graph. Model. 21 (2002)
// 195).
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "pliant/model/rigidity/rigidity_network.hpp"

namespace pliant {

/// The network with its `hydrogen_bonds` strongest hydrogen bonds and salt bridges.
struct DilutionRow {
  std::size_t hydrogen_bonds = 0;          ///< so many are left
  std::size_t freedoms = 0;                ///< internal degrees of freedom
  std::size_t redundant = 0;               ///< bars
  std::size_t components = 0;              ///< parts that nothing links
  std::size_t clusters = 0;                ///< of three atoms or more
  std::array<std::uint32_t, 5> largest{};  ///< their atoms; 0 where there are fewer
};

/// Sees each row, and the clusters of atoms at that row.
using DilutionObserver = std::function<void(const DilutionRow& row, const ClusterList& clusters)>;

/// Rows from all hydrogen bonds to none, one more than there are hydrogen bonds. The pebble game is
/// played once, from no hydrogen bond to all, so rows come to `observer` in that order: the last
/// row first. Time grows with hydrogen bonds x atoms. Where an end no longer has any hydrogen bond,
/// its turning counts no more.
std::vector<DilutionRow> dilute_hydrogen_bonds(const RigidityNetwork& network,
                                               const DilutionObserver& observer = {});

}  // namespace pliant
