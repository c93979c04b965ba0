// SPDX-License-Identifier: MIT
// Rigid and flexible parts of a molecule: rigid clusters of atoms, degrees of freedom, redundant
// bars, and the flexibility of bonds and residues.
#pragma once

#include <span>
#include <vector>

#include "pliant/model/model.hpp"
#include "pliant/model/rigidity/rigidity_network.hpp"

namespace pliant {

/// Flexibility of a residue.
struct ResidueFlexibility {
  double index = 0.0;          ///< mean over its bonds that may turn; 0 if there are none
  std::uint32_t bonds = 0;     ///< number of these bonds
  std::uint32_t flexible = 0;  ///< those between different clusters
  std::uint32_t cluster = 0;   ///< the largest with an atom of the residue
};

struct Rigidity {
  RigidityNetwork network;
  RigidClusters found;                       ///< with atoms as bodies
  std::vector<double> flexibility;           ///< (E) flexibility_indices() of the edges
  std::vector<ResidueFlexibility> residues;  ///< (R)
  std::size_t hinges = 0;                    ///< bonds that may turn
  std::size_t flexible_bonds = 0;            ///< those between different clusters
  /// rings of six bonds that may turn: boats can move, which the count does not show
  std::size_t rings_of_six = 0;

  bool is_flexible(std::size_t edge) const {
    const BodyEdge& at = network.edges[edge];
    return found.clusters.of_body[at.a] != found.clusters.of_body[at.b];
  }
};

/// Counts the freedoms of a structure with its bonds, hydrogens and contacts (body-bar pebble game:
/// pebble_game.hpp; network: rigidity_network.hpp). The flexibility of residues with atoms N, CA
/// and C is that of N-CA and CA-C; in other residues all bonds between their atoms count. Linear
/// memory, nearly linear time. Throws as rigidity_network().
Rigidity analyse_rigidity(const Structure& structure, std::span<const MolecularContact> contacts,
                          const RigidityOptions& options = {});

/// A prepared structure and its contacts: build_model() without bars and sterics.
struct ContactModel {
  Structure structure;
  std::vector<MolecularContact> contacts;
  std::vector<std::string> notes;     ///< what was done, one sentence each
  std::vector<std::string> missing;   ///< what the structure lacks
  std::vector<std::string> left_out;  ///< what of the file is not in it: see Preparation
};

/// Prepares a structure and finds its contacts, or takes those of the options. Linear in the number
/// of atoms. Throws as prepare() and read_contacts() do.
ContactModel contact_model(const Structure& structure, const ModelOptions& options = {});

}  // namespace pliant
