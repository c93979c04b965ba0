// SPDX-License-Identifier: MIT
#include "edits/ring_words.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace pliant::play {
namespace {

/// Larger ones turn about their bonds.
constexpr std::size_t most_atoms = 8;

using Adjacent = std::vector<std::vector<Joint>>;

Adjacent adjacent_of(const Document& document) {
  Adjacent adjacent(document.framework.joint_count());
  for (const Bond& bond : document.bonds) {
    adjacent[bond.a].push_back(bond.b);
    adjacent[bond.b].push_back(bond.a);
  }
  return adjacent;
}

/// Lengthens `path`, which begins with the joint of the ring, until a bond leads back to it.
bool closes(const Adjacent& adjacent, std::vector<Joint>& path, std::size_t atoms) {
  for (const Joint next : adjacent[path.back()]) {
    if (path.size() == atoms && next == path.front()) return true;
    if (path.size() == atoms || std::ranges::count(path, next)) continue;
    path.push_back(next);
    if (closes(adjacent, path, atoms)) return true;
    path.pop_back();
  }
  return false;
}

/// The smallest ring; none if there is none.
std::vector<Joint> ring_of(const Document& document, Joint joint) {
  const Adjacent adjacent = adjacent_of(document);
  for (std::size_t atoms = 3; atoms <= most_atoms; ++atoms) {
    std::vector<Joint> path{joint};
    if (closes(adjacent, path, atoms)) return path;
  }
  return {};
}

}  // namespace

std::string ring_text(const Document& document, Joint joint) {
  if (document.kind == "graph") return "";
  const std::vector<Joint> ring = ring_of(document, joint);
  if (ring.empty()) return "";
  const AtomTable& atoms = document.atoms;
  const bool is_of_one = document.has_residues && std::ranges::all_of(ring, [&](Joint one) {
                           return atoms.residue_of[one] == atoms.residue_of[joint];
                         });
  if (!is_of_one) return "a ring of " + std::to_string(ring.size()) + " atoms";
  const Residue& residue = atoms.residues[atoms.residue_of[joint]];
  return "the ring of " + residue.name + std::to_string(residue.number);
}

}  // namespace pliant::play
