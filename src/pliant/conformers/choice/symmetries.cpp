// SPDX-License-Identifier: MIT
#include "pliant/conformers/choice/symmetries.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace pliant {
namespace {

using Index = std::uint32_t;
using Neighbours = std::vector<std::vector<Index>>;

constexpr Index unset = ~Index{0};
constexpr std::size_t most_trials = 200000;

class SymmetrySearch {
 public:
  SymmetrySearch(const Neighbours& neighbours, const std::vector<Index>& kinds, std::size_t most)
      : neighbours_(neighbours),
        kinds_(kinds),
        most_(most),
        image_(kinds.size(), unset),
        is_taken_(kinds.size(), false) {
    order_by_bonds();
  }

  std::vector<std::vector<Index>> find(bool& is_complete) {
    visit(0);
    is_complete = maps_.size() < most_ && trials_ < most_trials;
    const auto is_identity = [](const std::vector<Index>& map) {
      return std::is_sorted(map.begin(), map.end());
    };
    const auto same = std::find_if(maps_.begin(), maps_.end(), is_identity);
    if (same != maps_.end())
      std::rotate(maps_.begin(), same, same + 1);
    else {
      std::vector<Index> map(kinds_.size());
      std::iota(map.begin(), map.end(), Index{0});
      maps_.insert(maps_.begin(), std::move(map));
    }
    return std::move(maps_);
  }

 private:
  /// Each atom after one that it is bonded to, but for the first of each part.
  void order_by_bonds() {
    std::vector<bool> seen(kinds_.size(), false);
    for (Index first = 0; first < kinds_.size(); ++first) {
      if (seen[first]) continue;
      seen[first] = true;
      order_.push_back(first);
      for (std::size_t k = order_.size() - 1; k < order_.size(); ++k)
        for (Index next : neighbours_[order_[k]])
          if (!seen[next]) {
            seen[next] = true;
            order_.push_back(next);
          }
    }
  }

  bool fits(Index atom, Index onto) const {
    if (kinds_[atom] != kinds_[onto] || is_taken_[onto]) return false;
    const auto& there = neighbours_[onto];
    return std::all_of(neighbours_[atom].begin(), neighbours_[atom].end(), [&](Index next) {
      return image_[next] == unset ||
             std::find(there.begin(), there.end(), image_[next]) != there.end();
    });
  }

  /// Atoms that `atom` may go to: neighbours of where one of its own neighbours went.
  std::vector<Index> candidates(Index atom) const {
    for (Index next : neighbours_[atom])
      if (image_[next] != unset) return neighbours_[image_[next]];
    std::vector<Index> all(kinds_.size());
    std::iota(all.begin(), all.end(), Index{0});
    return all;
  }

  void visit(std::size_t depth) {
    if (maps_.size() >= most_ || ++trials_ > most_trials) return;
    if (depth == order_.size()) {
      maps_.push_back(image_);
      return;
    }
    const Index atom = order_[depth];
    for (Index onto : candidates(atom)) {
      if (!fits(atom, onto)) continue;
      image_[atom] = onto;
      is_taken_[onto] = true;
      visit(depth + 1);
      image_[atom] = unset;
      is_taken_[onto] = false;
    }
  }

  const Neighbours& neighbours_;
  const std::vector<Index>& kinds_;
  std::size_t most_, trials_ = 0;
  std::vector<Index> order_, image_;
  std::vector<bool> is_taken_;
  std::vector<std::vector<Index>> maps_;
};

/// The same number for the same key; the numbers do not depend on the order of atoms.
template <class Key>
std::vector<Index> numbered(const std::vector<Key>& keys) {
  std::map<Key, Index> known;
  for (const Key& key : keys) known.emplace(key, 0);
  Index next = 0;
  for (auto& [key, number] : known) number = next++;
  std::vector<Index> numbers;
  for (const Key& key : keys) numbers.push_back(known.at(key));
  return numbers;
}

/// Atoms of one kind have neighbours of the same kinds.
std::vector<Index> refined(const Neighbours& neighbours, std::vector<Index> kinds) {
  for (std::size_t round = 0; round < kinds.size(); ++round) {
    std::vector<std::vector<Index>> keys;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      std::vector<Index> key;
      for (Index next : neighbours[k]) key.push_back(kinds[next]);
      std::sort(key.begin(), key.end());
      key.insert(key.begin(), kinds[k]);
      keys.push_back(std::move(key));
    }
    std::vector<Index> next = numbered(keys);
    const bool is_same = *std::max_element(next.begin(), next.end()) ==
                         *std::max_element(kinds.begin(), kinds.end());
    kinds = std::move(next);
    if (is_same) break;
  }
  return kinds;
}

/// Element, heavy bonds, hydrogens.
std::vector<Index> first_kind(const Framework& framework, const BondChemistry& chemistry,
                              Joint atom) {
  const Index element = framework.atoms()->elements[atom];
  const auto heavy = Index(chemistry.heavy_bonds_at(atom));
  const Index hydrogens = Index(chemistry.bonds_at(atom).size()) - heavy;
  const bool is_terminal = heavy == 1 && (element == 7 || element == 8 || element == 16);
  const bool is_flat = !chemistry.is_tetrahedral(chemistry.reference(atom, atom));
  return {element, heavy, is_terminal && is_flat ? 0 : hydrogens};
}

}  // namespace

Symmetries symmetries(const Framework& framework, const BondChemistry& chemistry,
                      std::size_t most) {
  Symmetries found;
  if (framework.atoms() == nullptr) return found;
  std::vector<Index> place(framework.joint_count(), unset);
  for (Joint atom = 0; atom < framework.joint_count(); ++atom)
    if (!chemistry.is_hydrogen(atom)) {
      place[atom] = Index(found.heavy.size());
      found.heavy.push_back(atom);
    }
  if (found.heavy.empty()) return found;
  Neighbours neighbours;
  std::vector<std::vector<Index>> keys;
  for (Joint atom : found.heavy) {
    keys.push_back(first_kind(framework, chemistry, atom));
    auto& near = neighbours.emplace_back();
    for (const Link& bond : chemistry.bonds_at(atom))
      if (place[bond.node] != unset) near.push_back(place[bond.node]);
  }
  const std::vector<Index> kinds = refined(neighbours, numbered(keys));
  found.maps = SymmetrySearch(neighbours, kinds, most).find(found.is_complete);
  return found;
}

}  // namespace pliant
