// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/stated_links.hpp"

#include <algorithm>
#include <array>

namespace pliant {
namespace {

std::string text_of(const AtomAddress& address) {
  std::string text(address.chain);
  if (!text.empty()) text += ":";
  text += std::to_string(address.number);
  if (address.insertion_code != ' ') text += address.insertion_code;
  return pliant::quoted(text.append(":").append(address.name));
}

/// Makes bonds of links, one after the other.
class LinkReader {
 public:
  LinkReader(AtomSites& sites, Remarks& remarks)
      : sites_(sites), remarks_(remarks), lookup_(sites.structure.atoms) {}

  void take(const StatedLink& link);

 private:
  bool find(const StatedLink& link, std::array<std::uint32_t, 2>& atoms);

  AtomSites& sites_;
  Remarks& remarks_;
  AtomLookup lookup_;
};

bool LinkReader::find(const StatedLink& link, std::array<std::uint32_t, 2>& atoms) {
  for (std::size_t k = 0; k < 2; ++k) {
    const LinkEnd& end = link.ends[k];
    const auto atom = lookup_.find(end.address);
    const bool other_conformer =
        end.conformer != ' ' && (!atom || sites_.conformers[*atom] != end.conformer);
    if (other_conformer) return false;
    if (!atom) {
      remarks_.warn("link to nothing", link.line, [&] {
        return std::string(link.record) + " names the atom " + text_of(end.address) +
               ", which is missing or not unique: bond left out";
      });
      return false;
    }
    atoms[k] = *atom;
  }
  return true;
}

void LinkReader::take(const StatedLink& link) {
  if (link.ends[0].symmetry != link.ends[1].symmetry) {
    remarks_.warn("link by symmetry", link.line, [&] {
      return std::string(link.record) + " leads to a copy by symmetry: bond left out";
    });
    return;
  }
  std::array<std::uint32_t, 2> atoms{};
  if (!find(link, atoms)) return;
  if (atoms[0] == atoms[1]) {
    remarks_.warn("link to itself", link.line,
                  [&] { return std::string(link.record) + " bonds an atom to itself: left out"; });
    return;
  }
  sites_.structure.bonds.push_back(
      {std::min(atoms[0], atoms[1]), std::max(atoms[0], atoms[1]), BondOrigin::file, link.order});
}

}  // namespace

void add_stated_links(AtomSites& sites, const std::vector<StatedLink>& links, Remarks& remarks) {
  if (links.empty()) return;
  LinkReader reader(sites, remarks);
  for (const StatedLink& link : links) reader.take(link);
}

}  // namespace pliant
