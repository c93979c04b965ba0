// SPDX-License-Identifier: MIT
// What of a molecule is rigid and what is flexible: rigid clusters of atoms, degrees of freedom,
// redundant bars, and the flexibility of bonds and residues.
#pragma once

#include <span>
#include <vector>

#include "pliant/model/model.hpp"
#include "pliant/model/rigidity/rigidity_network.hpp"

namespace pliant {

/// How flexible a residue is.
struct ResidueFlexibility {
  double index = 0.0;          ///< the mean of its bonds that may turn; 0 where there are none
  std::uint32_t bonds = 0;     ///< so many of them
  std::uint32_t flexible = 0;  ///< of these, between different clusters
  std::uint32_t cluster = 0;   ///< the largest that has an atom of it
};

struct Rigidity {
  RigidityNetwork network;
  RigidClusters found;                       ///< bodies are atoms
  std::vector<double> flexibility;           ///< (E) of each edge: flexibility_indices()
  std::vector<ResidueFlexibility> residues;  ///< (R)
  std::size_t hinges = 0;                    ///< bonds that may turn
  std::size_t flexible_bonds = 0;            ///< of these, between different clusters
  std::size_t rings_of_six = 0;              ///< of bonds that may turn: a boat moves, uncounted

  bool is_flexible(std::size_t edge) const {
    const BodyEdge& at = network.edges[edge];
    return found.clusters.of_body[at.a] != found.clusters.of_body[at.b];
  }
};

/// Counts the freedoms of a structure with its bonds, hydrogens and contacts (body-bar pebble game:
/// pebble_game.hpp; network: rigidity_network.hpp). Residues with atoms N, CA and C are rated by
/// N-CA and CA-C, others by all bonds between two atoms of theirs. Linear memory, near linear time.
/// Throws as rigidity_network().
Rigidity analyse_rigidity(const Structure& structure, std::span<const MolecularContact> contacts,
                          const RigidityOptions& options = {});

/// A structure made ready, and its contacts: what build_model() has without bars and sterics.
struct ContactModel {
  Structure structure;
  std::vector<MolecularContact> contacts;
  std::vector<std::string> told;     ///< what was done, line by line
  std::vector<std::string> missing;  ///< what the file lacks
};

/// Prepares a structure and finds its contacts, or takes those of the options. Linear in the number
/// of atoms. Throws as prepare() and read_contacts() do.
ContactModel contact_model(const Structure& structure, const ModelOptions& options = {});

}  // namespace pliant
