// SPDX-License-Identifier: MIT
// A molecule as bodies joined by bars, as FIRST counts freedoms: each atom is a body, bonds and
// contacts are edges.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/rigidity/rigid_clusters.hpp"

namespace pliant {

/// Numbers of bars of edges that are not bonds. A hinge has five; a bond that does not turn six.
struct RigidityOptions {
  /// Bars of kinds of contacts that differ from the table of kinds: 0 to 6, where 0 leaves the kind
  /// out; 1 to 6 for kinds with a hydrogen, which are diluted.
  std::map<MolecularContactKind, std::uint8_t> bars = {};
  /// Whether the bond to an atom without other bonds turns if a hydrogen bond holds that atom, as
  /// in FIRST: D-H of D-H..A, and A-B if B is the only neighbour of A.
  bool ends_turn = true;
  /// Atoms at which no angle is fixed (Si-O-Si of a silicate): ball joints of their neighbours.
  /// Each needs a neighbour with several bonds whose own angles are fixed.
  std::vector<std::uint32_t> free_angles = {};
};

/// Edges of the network: first Structure::bonds in their order, then contacts without a hydrogen,
/// kinds with most bars first, then those with one (hydrogen bonds, salt bridges) from the
/// lowest energy to the highest.
struct RigidityNetwork {
  std::size_t atoms = 0;
  std::vector<BodyEdge> edges;          ///< (E)
  std::size_t bonds = 0;                ///< edges that are bonds
  std::size_t first_hydrogen_bond = 0;  ///< index of that edge
  std::vector<std::uint32_t> contacts;  ///< (E - bonds) contact of each other edge
  /// Bonds to an atom without other bonds, which turn because a hydrogen bond holds the atom.
  std::vector<std::uint32_t> turning_ends;

  bool is_bond(std::size_t edge) const { return edge < bonds; }
  std::uint32_t contact_of(std::size_t edge) const { return contacts[edge - bonds]; }
};

/// The network of a structure whose bonds are known (perceive_bonds) and of its contacts. Six bars:
/// double, triple and aromatic bonds, amides and the like (find_locked_bonds), and bonds to an atom
/// without other bonds, whose turning moves nothing. Five bars: all other bonds. An atom with free
/// angles counts as a point: it has six bars to its first neighbour with fixed angles, three to
/// each other such neighbour, four to an atom without other bonds, and one to another atom with
/// free angles. Throws InputError if a contact has an atom that does not exist; OptionError for too
/// many bars, and for an atom whose angles cannot be free.
RigidityNetwork rigidity_network(const Structure& structure,
                                 std::span<const MolecularContact> contacts,
                                 const RigidityOptions& options = {});

}  // namespace pliant
