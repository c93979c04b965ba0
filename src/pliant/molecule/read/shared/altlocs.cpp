// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/altlocs.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <numeric>

namespace pliant {
namespace {

constexpr std::size_t letters = 256;
using LetterSet = std::bitset<letters>;

std::size_t index_of(char conformer) { return static_cast<unsigned char>(conformer); }

/// Atoms of one name, one after the other.
using Indices = std::vector<std::size_t>;

Indices sorted_by_name(const std::vector<AltlocAtom>& atoms) {
  Indices order(atoms.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t p, std::size_t q) { return atoms[p].name < atoms[q].name; });
  return order;
}

/// Calls `visit(first, last)` for each run of atoms with one name.
template <class Visit>
void for_each_name(const std::vector<AltlocAtom>& atoms, const Indices& order, Visit visit) {
  for (auto first = order.begin(); first != order.end();) {
    const auto last = std::find_if(
        first, order.end(), [&](std::size_t k) { return atoms[k].name != atoms[*first].name; });
    visit(first, last);
    first = last;
  }
}

struct Contest {
  std::array<LetterSet, letters> rivals;     // conformers that share a name with each
  std::array<double, letters> occupancy{};   // sums
  std::array<std::size_t, letters> count{};  // atoms summed
  Indices by_appearance;                     // conformers that compete, first of the file first

  double mean(std::size_t letter) const {
    return count[letter] == 0 ? 0.0 : occupancy[letter] / static_cast<double>(count[letter]);
  }
};

/// Atoms without a conformer count only where their name has one, too.
Contest hold(const std::vector<AltlocAtom>& atoms, const Indices& order) {
  Contest contest;
  LetterSet seen;
  std::vector<bool> counts(atoms.size(), false);
  for_each_name(atoms, order, [&](auto first, auto last) {
    LetterSet present;
    for (auto k = first; k != last; ++k) present.set(index_of(atoms[*k].conformer));
    for (auto k = first; k != last; ++k) {
      const std::size_t letter = index_of(atoms[*k].conformer);
      contest.rivals[letter] |= present;
      counts[*k] = letter != index_of(' ') || present.count() > 1;
    }
  });
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    if (!counts[k]) continue;
    const std::size_t letter = index_of(atoms[k].conformer);
    contest.occupancy[letter] += static_cast<double>(atoms[k].occupancy);
    ++contest.count[letter];
    if (!seen.test(letter)) contest.by_appearance.push_back(letter);
    seen.set(letter);
  }
  return contest;
}

LetterSet winners(Contest& contest) {
  std::stable_sort(contest.by_appearance.begin(), contest.by_appearance.end(),
                   [&](std::size_t p, std::size_t q) { return contest.mean(p) > contest.mean(q); });
  LetterSet chosen;
  for (std::size_t letter : contest.by_appearance)
    if ((contest.rivals[letter] & chosen).none()) chosen.set(letter);
  return chosen;
}

}  // namespace

std::vector<bool> choose_altlocs(const std::vector<AltlocAtom>& atoms) {
  const Indices order = sorted_by_name(atoms);
  Contest contest = hold(atoms, order);
  const LetterSet chosen = winners(contest);
  std::vector<bool> stays(atoms.size());
  for_each_name(atoms, order, [&](auto first, auto last) {
    const bool named_by_chosen = std::any_of(
        first, last, [&](std::size_t k) { return chosen.test(index_of(atoms[k].conformer)); });
    for (auto k = first; k != last; ++k) {
      const char conformer = atoms[*k].conformer;
      stays[*k] = chosen.test(index_of(conformer)) || (conformer == ' ' && !named_by_chosen);
    }
  });
  return stays;
}

}  // namespace pliant
