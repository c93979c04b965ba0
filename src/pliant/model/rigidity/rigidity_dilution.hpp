// SPDX-License-Identifier: MIT
// Dilution: hydrogen bonds are removed one by one, the weakest first, and rigid clusters break up
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
  std::size_t hydrogen_bonds = 0;          ///< number of hydrogen bonds that are left
  std::size_t freedoms = 0;                ///< internal degrees of freedom
  std::size_t redundant = 0;               ///< number of redundant bars
  std::size_t components = 0;              ///< connected components
  std::size_t clusters = 0;                ///< with three atoms or more
  std::array<std::uint32_t, 5> largest{};  ///< numbers of their atoms; 0 if there are fewer
};

/// Receives each row, and its clusters of atoms.
using DilutionObserver = std::function<void(const DilutionRow& row, const ClusterList& clusters)>;

/// Returns the rows from all hydrogen bonds to none, one more than there are hydrogen bonds. The
/// pebble game is played once, from no hydrogen bond to all, so that `observer` gets the rows in
/// reverse. Time grows with hydrogen bonds x atoms. An end that has lost all its hydrogen bonds no
/// longer counts as turning.
std::vector<DilutionRow> dilute_hydrogen_bonds(const RigidityNetwork& network,
                                               const DilutionObserver& observer = {});

}  // namespace pliant
