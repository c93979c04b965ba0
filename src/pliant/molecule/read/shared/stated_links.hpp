// SPDX-License-Identifier: MIT
// Bonds between residues given by single records: SSBOND and LINK of PDB, struct_conn of mmCIF. The
// same rules decide for both formats which links become bonds.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pliant/molecule/read/shared/atom_sites.hpp"
#include "pliant/molecule/structure/atom_lookup.hpp"

namespace pliant {

/// One end of a link.
struct LinkEnd {
  AtomAddress address;
  char conformer = ' ';       ///< alternate location; ' ' for any
  std::string_view symmetry;  ///< operator; "" for the identity
};

/// A link between two atoms as a file states it.
struct StatedLink {
  LinkEnd ends[2];
  std::string_view record;  ///< "SSBOND", for messages
  std::size_t line;
  std::uint8_t order = 0;
};

/// Adds the bonds of `links` to `sites.structure.bonds`, those of metals, too: bond perception
/// tells coordination from bonds. Left out with one remark each: links to symmetry copies and of
/// missing atoms; without a remark: links of alternate locations that are not used.
void add_stated_links(AtomSites& sites, const std::vector<StatedLink>& links, Remarks& remarks);

}  // namespace pliant
