// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <utility>

#include "document.hpp"
#include "pliant/model/rigidity/dilution_picture.hpp"
#include "pliant/model/rigidity/rigidity.hpp"

namespace pliant::play {
namespace {

using Pair = std::pair<Joint, Joint>;

std::set<Pair> pairs_of(const Framework& framework) {
  std::set<Pair> pairs;
  for (const Bar bar : framework.bars()) pairs.insert(std::minmax(bar.a, bar.b));
  return pairs;
}

std::set<std::uint32_t> groups_of(const Framework& framework) {
  std::set<std::uint32_t> groups;
  for (const Limit& limit : framework.limits()) groups.insert(limit.group);
  return groups;
}

/// Contacts whose limits have all gone are gone; some never had any, where bars hold their atoms.
std::vector<MolecularContact> contacts_left(const Document& document, const Framework& now) {
  const auto before = groups_of(document.framework), after = groups_of(now);
  std::vector<MolecularContact> left;
  for (std::uint32_t k = 0; k < document.contacts.size(); ++k)
    if (after.contains(k) || !before.contains(k)) left.push_back(document.contacts[k]);
  return left;
}

/// A bond whose bar was cut holds nothing.
Structure with_bonds_left(const Document& document, const Framework& now) {
  Structure structure = *document.made;
  const auto before = pairs_of(document.framework), after = pairs_of(now);
  std::erase_if(structure.bonds, [&](const Bond& bond) {
    const Pair pair{bond.a, bond.b};
    return before.contains(pair) && !after.contains(pair);
  });
  return structure;
}

void find_clusters(Document& document, const Document& document_at_start,
                   const EditedFramework& edited, const Structure& structure) {
  RigidityNetwork network = rigidity_network(structure, document.contacts);
  auto added = pairs_of(edited.framework);
  for (const Pair& pair : pairs_of(document_at_start.framework)) added.erase(pair);
  for (const auto& [a, b] : added) network.edges.push_back({a, b, 1});
  document.clusters = find_rigid_clusters(network.atoms, network.edges).clusters;
  document.coloured_clusters = coloured_clusters(structure, document.clusters);
}

}  // namespace

Document after_edits(const Document& document, const EditedFramework& edited) {
  Document now = document;
  now.framework = edited.framework;
  if (!document.made) {
    now.bonds.clear();
    for (const Bar bar : now.framework.bars())
      now.bonds.push_back({std::min(bar.a, bar.b), std::max(bar.a, bar.b), BondOrigin::file, 0});
    return now;
  }
  now.contacts = contacts_left(document, edited.framework);
  const Structure structure = with_bonds_left(document, edited.framework);
  now.bonds = structure.bonds;
  find_clusters(now, document, edited, structure);
  return now;
}

}  // namespace pliant::play
