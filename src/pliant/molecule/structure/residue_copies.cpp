// SPDX-License-Identifier: MIT
#include "pliant/molecule/structure/residue_copies.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "pliant/base/elements.hpp"
#include "pliant/base/graphs/disjoint_sets.hpp"
#include "pliant/base/graphs/grouped.hpp"
#include "pliant/base/math/cell_list.hpp"
#include "pliant/molecule/structure/residue_templates.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t hydrogen = 1;

// Heavy atoms of two molecules are never as near (Angstrom); alternate locations mostly are.
constexpr double least_between_copies = 2.0;

// What bonds by distance allow beyond the sum of two covalent radii (Angstrom).
constexpr double slack = 0.45;

// A cube as wide as a bond's cut-off, up to 6 Angstrom for metals, holds less atoms of matter.
constexpr std::size_t most_in_a_cell = 100;

/// All that names a residue.
struct Key {
  std::string_view chain, segment, name;
  std::int64_t number;
  char insertion_code;
  bool unnumbered;

  friend bool operator==(const Key&, const Key&) = default;
};

struct KeyHash {
  std::size_t operator()(const Key& key) const {
    const std::hash<std::string_view> text;
    std::size_t hash = text(key.name);
    for (const std::size_t part :
         {text(key.chain), text(key.segment), static_cast<std::size_t>(key.number),
          static_cast<std::size_t>(key.insertion_code)})
      hash = (hash ^ part) * 0x9e3779b97f4a7c15ULL + (hash >> 29);
    return hash;
  }
};

/// Neighbours [first, last) of one residue.
struct Unit {
  std::uint32_t first, last;
};

/// What no two heavy atoms of one residue share: name and alternate location.
using AtomName = std::pair<std::string_view, char>;

AtomName atom_name(const ListedResidues& listed, std::uint32_t atom) {
  return {listed.atoms.names[atom], listed.conformer(atom)};
}

/// Whether an atom's name tells more than its element does, as those of molecules of XYZ files do
/// not. In a standard residue "C" is a name, and so is "NA" of the ion NA.
bool is_name(const ListedResidues& listed, std::uint32_t atom) {
  const AtomTable& atoms = listed.atoms;
  const std::string& residue = listed.residue(atom).name;
  return element_number(atoms.names[atom]) != atoms.elements[atom] ||
         atoms.names[atom] == residue || find_residue_template(residue) != nullptr;
}

/// Splits copies of one residue whose parts stand apart.
class CopiesByDistance {
 public:
  CopiesByDistance(const ListedResidues& listed, std::span<const Unit> units) : listed_(listed) {
    for (const Unit& unit : units)
      for (std::uint32_t atom = unit.first; atom < unit.last; ++atom) atoms_.push_back(atom);
    sets_.reset(atoms_.size());
    settled_.assign(atoms_.size(), false);
    names_.resize(atoms_.size());
    for (std::uint32_t k = 0; k < atoms_.size(); ++k)
      if (!is_hydrogen(k) && is_name(listed, atoms_[k]))
        names_[k].push_back(atom_name(listed, atoms_[k]));
  }

  /// Bonded atoms are one residue, nearest pairs first, and then neighbours in the list, but never
  /// two heavy atoms of one name.
  void run(std::vector<std::uint32_t>& leader) {
    for (const Pair& pair : bonded_pairs()) {
      if (is_bonded_hydrogen(pair.a) || is_bonded_hydrogen(pair.b)) continue;
      if (!unite(pair.a, pair.b)) continue;
      settled_[pair.a] = settled_[pair.b] = true;
    }
    for (std::uint32_t k = 1; k < atoms_.size(); ++k)
      if (atoms_[k] == atoms_[k - 1] + 1 && !is_hydrogen(k) && !is_hydrogen(k - 1)) unite(k - 1, k);
    for (std::uint32_t k = 0; k < atoms_.size(); ++k) leader[atoms_[k]] = atoms_[sets_.find(k)];
  }

  std::span<const std::uint32_t> atoms() const { return atoms_; }

 private:
  struct Pair {
    double ratio;  ///< distance / sum of radii
    std::uint32_t a, b;
    auto operator<=>(const Pair&) const = default;
  };

  bool is_hydrogen(std::uint32_t k) const { return element(k) == hydrogen; }
  bool is_bonded_hydrogen(std::uint32_t k) const { return is_hydrogen(k) && settled_[k]; }
  std::uint8_t element(std::uint32_t k) const { return listed_.atoms.elements[atoms_[k]]; }
  double radius(std::uint32_t k) const {
    constexpr double unknown = 0.75;
    const double known = covalent_radius(element(k));
    return known > 0.0 ? known : unknown;
  }

  /// Pairs that could be bonded, nearest first; none where atoms lie on top of each other.
  std::vector<Pair> bonded_pairs() const {
    std::vector<Vec3> points;
    double largest = 0.0;
    for (std::uint32_t k = 0; k < atoms_.size(); ++k) {
      points.push_back(listed_.positions[atoms_[k]]);
      largest = std::max(largest, radius(k));
    }
    const CellList cells(points, 2.0 * largest + slack);
    std::vector<Pair> pairs;
    if (!cells.points_in_cells_above(most_in_a_cell).empty()) return pairs;
    cells.for_each_pair([&](std::uint32_t a, std::uint32_t b, double squared) {
      const double radii = radius(a) + radius(b);
      const double length = std::sqrt(squared);
      if (length > radii + slack || (is_hydrogen(a) && is_hydrogen(b))) return;
      pairs.push_back({length / radii, std::min(a, b), std::max(a, b)});
    });
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  /// Unless a heavy atom's name would come twice.
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = sets_.find(a);
    b = sets_.find(b);
    if (a == b) return true;
    std::vector<AtomName> all;
    std::merge(names_[a].begin(), names_[a].end(), names_[b].begin(), names_[b].end(),
               std::back_inserter(all));
    if (std::adjacent_find(all.begin(), all.end()) != all.end()) return false;
    sets_.unite(a, b);
    names_[std::min(a, b)] = std::move(all);
    names_[std::max(a, b)].clear();
    return true;
  }

  const ListedResidues& listed_;
  std::vector<std::uint32_t> atoms_;
  DisjointSets sets_;
  std::vector<std::vector<AtomName>> names_;  ///< by set, sorted
  std::vector<bool> settled_;
};

class Gathering {
 public:
  explicit Gathering(const ListedResidues& listed) : listed_(listed) {
    copies_.leader.resize(listed.atoms.size());
  }

  ResidueCopies run() {
    find_units();
    group_units();
    const Grouped<std::uint32_t> groups(group_count_, [&](const auto& put) {
      for (std::uint32_t u = 0; u < units_.size(); ++u) put(group_of_[u], u);
    });
    std::vector<Unit> members;
    for (std::uint32_t g = 0; g < group_count_; ++g) {
      members.clear();
      for (const std::uint32_t u : groups.at(g)) members.push_back(units_[u]);
      settle(members);
    }
    std::sort(copies_.by_distance.begin(), copies_.by_distance.end());
    return std::move(copies_);
  }

 private:
  void find_units() {
    const auto& residue_of = listed_.atoms.residue_of;
    const auto count = static_cast<std::uint32_t>(residue_of.size());
    std::uint32_t heavy = 0;  // the last heavy atom
    for (std::uint32_t i = 0; i < count; ++i) {
      const bool begins = i == 0 || residue_of[i] != residue_of[i - 1];
      if (begins || begins_copy(units_.back().first, heavy, i)) {
        if (!units_.empty()) units_.back().last = i;
        units_.push_back({i, count});
      }
      if (listed_.atoms.elements[i] != hydrogen) heavy = i;
    }
  }

  bool begins_copy(std::uint32_t first, std::uint32_t heavy, std::uint32_t atom) const {
    const auto& names = listed_.atoms.names;
    const auto& at = listed_.positions;
    return names[atom] == names[first] && listed_.atoms.elements[atom] != hydrogen &&
           listed_.conformer(atom) == listed_.conformer(first) &&
           distance(at[atom], at[first]) >= least_between_copies &&
           distance(at[atom], at[heavy]) >= least_between_copies && is_name(listed_, atom);
  }

  void group_units() {
    std::unordered_map<Key, std::uint32_t, KeyHash> known;
    known.reserve(units_.size());
    for (const Unit& unit : units_) {
      const std::uint32_t run = listed_.atoms.residue_of[unit.first];
      const Residue& residue = listed_.atoms.residues[run];
      const bool unnumbered = !listed_.unnumbered.empty() && listed_.unnumbered[run] != 0;
      const Key key{residue.chain,          listed_.segment(run),
                    residue.name,           unnumbered ? 0 : residue.number,
                    residue.insertion_code, unnumbered};
      const auto [at, is_new] = known.try_emplace(key, group_count_);
      group_count_ += is_new;
      group_of_.push_back(at->second);
    }
  }

  void settle(std::span<const Unit> members) {
    if (members.size() == 1 || each_is_whole(members)) {
      for (const Unit& unit : members) lead(unit, unit.first);
    } else if (no_name_comes_twice(members)) {
      for (const Unit& unit : members) lead(unit, members[0].first);
    } else {
      CopiesByDistance copies(listed_, members);
      copies.run(copies_.leader);
      copies_.by_distance.insert(copies_.by_distance.end(), copies.atoms().begin(),
                                 copies.atoms().end());
    }
  }

  void lead(const Unit& unit, std::uint32_t leader) {
    std::fill(copies_.leader.begin() + unit.first, copies_.leader.begin() + unit.last, leader);
  }

  bool is_heavy(std::uint32_t atom) const { return listed_.atoms.elements[atom] != hydrogen; }

  /// Whether each has the first heavy atom of all, and no more hydrogens than are its own, as
  /// copies one after another have.
  bool each_is_whole(std::span<const Unit> members) const {
    std::uint32_t first = members[0].first;
    while (first < members[0].last && !is_heavy(first)) ++first;
    if (first == members[0].last) return false;
    return std::ranges::all_of(members, [&](const Unit& unit) {
      for (std::uint32_t atom = unit.first; atom < unit.last; ++atom)
        if (is_heavy(atom) && atom_name(listed_, atom) == atom_name(listed_, first))
          return !has_hydrogens_of_others(unit);
      return false;
    });
  }

  bool has_hydrogens_of_others(const Unit& unit) const {
    std::vector<AtomName> names;
    for (std::uint32_t atom = unit.first; atom < unit.last; ++atom)
      if (!is_heavy(atom) && listed_.atoms.names[atom].size() > 1)
        names.push_back(atom_name(listed_, atom));
    std::sort(names.begin(), names.end());
    return std::adjacent_find(names.begin(), names.end()) != names.end();
  }

  bool no_name_comes_twice(std::span<const Unit> members) const {
    std::vector<AtomName> names;
    for (const Unit& unit : members)
      for (std::uint32_t atom = unit.first; atom < unit.last; ++atom)
        if (is_heavy(atom)) names.push_back(atom_name(listed_, atom));
    std::sort(names.begin(), names.end());
    return std::adjacent_find(names.begin(), names.end()) == names.end();
  }

  const ListedResidues& listed_;
  std::vector<Unit> units_;
  std::vector<std::uint32_t> group_of_;
  std::uint32_t group_count_ = 0;
  ResidueCopies copies_;
};

}  // namespace

ResidueCopies residue_copies(const ListedResidues& listed) { return Gathering(listed).run(); }

}  // namespace pliant
