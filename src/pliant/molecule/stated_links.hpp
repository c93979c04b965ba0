// SPDX-License-Identifier: MIT
// Bonds between residues that records state one by one: SSBOND and LINK of PDB, struct_conn of
// mmCIF. What becomes a bond and what does not is the same for both formats.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pliant/molecule/atom_lookup.hpp"
#include "pliant/molecule/atom_sites.hpp"

namespace pliant {

/// One end of a stated link.
struct LinkEnd {
  AtomAddress address;
  char conformer = ' ';       ///< alternate location that is meant; ' ' for any
  std::string_view symmetry;  ///< operator; "" for the identity
};

/// A stated link.
struct StatedLink {
  LinkEnd ends[2];
  std::string_view record;  ///< "SSBOND", for messages
  std::size_t line;
  std::uint8_t order = 0;
};

/// Adds the bonds of `links` to `sites.structure.bonds`. Left out, each said once: links to copies
/// by symmetry, links of a metal (coordination is no bar of fixed length), and links of atoms that
/// are not there; silently, those of alternate locations that are not used.
void add_stated_links(AtomSites& sites, const std::vector<StatedLink>& links, Remarks& remarks);

}  // namespace pliant
