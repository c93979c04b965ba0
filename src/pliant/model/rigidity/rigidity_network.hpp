// SPDX-License-Identifier: MIT
// A molecule as bodies joined by bars, for counting its freedoms as FIRST does: each atom is a
// body, bonds and molecular contacts are edges.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/rigidity/rigid_clusters.hpp"

namespace pliant {

/// A bond that turns, a hinge, has five bars; one that does not six.
struct RigidityOptions {
  /// Bars of kinds of contacts, other than the table of kinds has them: 0 to 6, where 0 leaves the
  /// kind out; of kinds with a hydrogen, which are diluted, 1 to 6.
  std::map<MolecularContactKind, std::uint8_t> bars = {};
  /// Whether the bond to an atom that has no other bond turns where a hydrogen bond holds that
  /// atom, as FIRST has it: D-H of D-H..A, and A-B where A has no other neighbour than B.
  bool ends_turn = true;
  /// Atoms at which no angle is held (Si-O-Si of a silicate): a ball joint of all that is bonded
  /// there. Each needs a neighbour that has several bonds and whose own angles are held.
  std::vector<std::uint32_t> free_angles = {};
};

/// Edges of the network. The first ones are Structure::bonds in their order, then come contacts
/// without a hydrogen, kinds of most bars first (metals, then hydrophobic contacts), then hydrogen
/// bonds and salt bridges from the lowest energy to the highest.
struct RigidityNetwork {
  std::size_t atoms = 0;
  std::vector<BodyEdge> edges;          ///< (E)
  std::size_t bonds = 0;                ///< edges that are bonds
  std::size_t first_hydrogen_bond = 0;  ///< the edge
  std::vector<std::uint32_t> contacts;  ///< (E - bonds) the contact of each further edge
  /// Edges that are bonds to an atom with no other bond, which turn as a hydrogen bond holds it.
  std::vector<std::uint32_t> turning_ends;

  bool is_bond(std::size_t edge) const { return edge < bonds; }
  std::uint32_t contact_of(std::size_t edge) const { return contacts[edge - bonds]; }
};

/// The network of a structure whose bonds are known (perceive_bonds) and of its contacts.
/// Six bars: double, triple and aromatic bonds, amides and their kin (find_locked_bonds), and bonds
/// to an atom that has no other bond, as its turning moves nothing. Five: all other bonds.
/// At an atom whose angles are free, which counts as a point: six to the first neighbour whose
/// angles are held, three to each other such neighbour, four to an atom that has no other bond, and
/// one to another atom whose angles are free.
/// Throws InputError if a contact names an atom that there is not; OptionError for too many bars,
/// and for an atom whose angles cannot be free.
RigidityNetwork rigidity_network(const Structure& structure,
                                 std::span<const MolecularContact> contacts,
                                 const RigidityOptions& options = {});

}  // namespace pliant
