// SPDX-License-Identifier: MIT
// Bonds between residues that records state one by one: SSBOND and LINK of PDB, struct_conn of
// mmCIF. What becomes a bond and what does not is the same for both formats.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pliant/molecule/read/shared/atom_sites.hpp"
#include "pliant/molecule/structure/atom_lookup.hpp"

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

/// Adds the bonds of `links` to `sites.structure.bonds`. A bond of a metal is one, as in CONECT:
/// what the file states is kept, so that a metal stays in its site and the PDB and the mmCIF file
/// of one entry agree. Left out, each said once: links to copies by symmetry and of atoms that are
/// not there; silently, those of alternate locations that are not used.
void add_stated_links(AtomSites& sites, const std::vector<StatedLink>& links, Remarks& remarks);

}  // namespace pliant
