// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/atom_sites.hpp"

#include <algorithm>
#include <compare>
#include <map>
#include <numeric>
#include <string>

#include "pliant/base/elements.hpp"
#include "pliant/molecule/read/shared/altlocs.hpp"
#include "pliant/molecule/read/shared/element_of_name.hpp"
#include "pliant/molecule/read/shared/gathering.hpp"
#include "pliant/molecule/structure/residue_order.hpp"
#include "pliant/molecule/structure/residue_templates.hpp"

namespace pliant {
namespace {

/// What names a place in a chain: residues of several names can share it.
struct Seat {
  std::string_view chain;
  std::int64_t number;
  char insertion_code;

  friend auto operator<=>(const Seat&, const Seat&) = default;
};

Seat seat_of(const Residue& residue) {
  return {residue.chain, residue.number, residue.insertion_code};
}

std::vector<bool> residues_with_conformers(const AtomSites& sites) {
  std::vector<bool> has(sites.structure.atoms.residues.size(), false);
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (sites.conformers[i] != ' ') has[sites.structure.atoms.residue_of[i]] = true;
  return has;
}

using Group = std::vector<std::uint32_t>;

/// Atoms of the residues that have alternate locations, together where they share a seat.
std::map<Seat, Group> groups_of(const AtomSites& sites) {
  const std::vector<bool> has = residues_with_conformers(sites);
  const AtomTable& atoms = sites.structure.atoms;
  std::map<Seat, Group> groups;
  Group* group = nullptr;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const std::uint32_t residue = atoms.residue_of[i];
    if (!has[residue]) continue;
    if (i == 0 || residue != atoms.residue_of[i - 1] || group == nullptr)
      group = &groups[seat_of(atoms.residues[residue])];
    group->push_back(static_cast<std::uint32_t>(i));
  }
  return groups;
}

/// Files of membrane proteins (OPM) draw the membrane with residues DUM; nothing is there.
void drop_dummies(const AtomSites& sites, std::vector<bool>& keep, Remarks& remarks) {
  const AtomTable& atoms = sites.structure.atoms;
  std::size_t count = 0;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (!is_membrane_dummy(atoms.residues[atoms.residue_of[i]])) continue;
    keep[i] = false;
    ++count;
  }
  if (count == 0) return;
  if (count == sites.size()) fail(remarks.place(0), "holds nothing but dummy atoms (residues DUM)");
  remarks.note(std::to_string(count) + (count == 1 ? " dummy atom" : " dummy atoms") +
               " (residues DUM, which draw a membrane) left out");
}

/// Clears `keep` for atoms of conformers that are not chosen, and warns of them.
void drop_conformers(const AtomSites& sites, std::vector<bool>& keep, Remarks& remarks) {
  std::size_t residues = 0, count = 0, first = 0;
  for (const auto& [seat, group] : groups_of(sites)) {
    std::vector<AltlocAtom> listed;
    for (std::uint32_t i : group)
      listed.push_back({sites.structure.atoms.names[i], sites.conformers[i], sites.occupancies[i]});
    const std::vector<bool> stays = choose_altlocs(listed);
    for (std::size_t k = 0; k < group.size(); ++k) {
      if (stays[k]) continue;
      keep[group[k]] = false;
      first = count++ == 0 ? group[k] : std::min<std::size_t>(first, group[k]);
    }
    residues += std::find(stays.begin(), stays.end(), false) != stays.end();
  }
  if (count == 0) return;
  remarks.warn("conformers", sites.lines[first], [&] {
    return std::to_string(count) + (count == 1 ? " atom" : " atoms") +
           " of alternate locations left out, in " + std::to_string(residues) +
           (residues == 1 ? " residue" : " residues") +
           ": the conformer of highest occupancy is used";
  });
}

/// Residue and name also where the molecule is a single residue: "A:ALA1:CA".
std::string full_label(const AtomTable& atoms, std::size_t atom) {
  const Residue& residue = atoms.residues[atoms.residue_of[atom]];
  std::string text = residue.chain.empty() ? "" : residue.chain + ":";
  text += residue.name + std::to_string(residue.number);
  if (residue.insertion_code != ' ') text += residue.insertion_code;
  return text + ":" + atoms.names[atom];
}

/// Whether the atom has no name but its element, as molecules of XYZ files, and as hydrogens that
/// programs add: nobody would look it up by that. In a standard residue "C" is a name.
bool is_bare_symbol(const AtomTable& atoms, std::size_t atom) {
  constexpr std::uint8_t hydrogen = 1;
  const std::uint8_t element = atoms.elements[atom];
  return element_number(atoms.names[atom]) == element &&
         (element == hydrogen || !is_standard_residue(atoms.residues[atoms.residue_of[atom]].name));
}

void warn_of_repeat(const AtomSites& sites, std::uint32_t atom, bool same_place, Remarks& remarks) {
  const AtomTable& atoms = sites.structure.atoms;
  const std::string label = full_label(atoms, atom);
  if (same_place) {
    remarks.warn("repeated atom", sites.lines[atom], [&] {
      return "atom " + label + " is given twice at one point: left out the second time";
    });
  } else if (!is_bare_symbol(atoms, atom)) {
    remarks.warn("repeated name", sites.lines[atom], [&] {
      return "atom " + label + " is given twice, at different points: both kept";
    });
  }
}

/// Looks at the kept atoms [first, last) of one residue for equal names. Sorting makes it
/// independent of how large a residue is.
void drop_repeats_in_residue(const AtomSites& sites, Group& atoms, std::vector<bool>& keep,
                             Remarks& remarks) {
  const auto& names = sites.structure.atoms.names;
  const auto& positions = sites.structure.positions;
  std::sort(atoms.begin(), atoms.end(), [&](std::uint32_t p, std::uint32_t q) {
    const int order = names[p].compare(names[q]);
    if (order != 0) return order < 0;
    const Vec3 a = positions[p], b = positions[q];
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z != b.z ? a.z < b.z : p < q;
  });
  for (std::size_t k = 1; k < atoms.size(); ++k) {
    if (names[atoms[k]] != names[atoms[k - 1]]) continue;
    const bool same_place = positions[atoms[k]] == positions[atoms[k - 1]];
    warn_of_repeat(sites, std::max(atoms[k], atoms[k - 1]), same_place, remarks);
    if (same_place) keep[atoms[k]] = false;
  }
}

bool has_equal_names(const AtomSites& sites, const Group& atoms) {
  constexpr std::size_t small = 40;
  const auto& names = sites.structure.atoms.names;
  if (atoms.size() > small) return true;
  for (std::size_t k = 0; k < atoms.size(); ++k)
    for (std::size_t l = 0; l < k; ++l)
      if (names[atoms[k]] == names[atoms[l]]) return true;
  return false;
}

void drop_repeats(const AtomSites& sites, std::vector<bool>& keep, Remarks& remarks) {
  const auto& residue_of = sites.structure.atoms.residue_of;
  Group group;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (keep[i]) group.push_back(static_cast<std::uint32_t>(i));
    if (i + 1 < sites.size() && residue_of[i + 1] == residue_of[i]) continue;
    if (has_equal_names(sites, group)) drop_repeats_in_residue(sites, group, keep, remarks);
    group.clear();
  }
}

/// Residues that lose all atoms go.
std::vector<std::uint32_t> keep_residues(Structure& structure, const std::vector<bool>& keep) {
  const auto& residue_of = structure.atoms.residue_of;
  auto& residues = structure.atoms.residues;
  std::vector<bool> used(residues.size(), false);
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i]) used[residue_of[i]] = true;
  std::vector<std::uint32_t> new_index(residues.size(), 0);
  std::uint32_t count = 0;
  for (std::size_t r = 0; r < residues.size(); ++r) {
    if (used[r] && count != r) residues[count] = std::move(residues[r]);
    count += used[r];
    new_index[r] = count == 0 ? 0 : count - 1;
  }
  residues.resize(count);
  return new_index;
}

/// A chain ends after what is left of it.
void move_chain_ends(std::vector<bool>& ends, const std::vector<bool>& before,
                     const std::vector<std::uint32_t>& new_index, std::size_t count) {
  if (before.empty()) return;
  ends.assign(count, false);
  for (std::size_t r = 0; r < before.size(); ++r)
    if (before[r]) ends[new_index[r]] = true;
}

/// `rows` are the atoms to keep.
void keep_atoms(AtomSites& sites, const std::vector<bool>& keep,
                const std::vector<std::uint32_t>& rows) {
  Structure& structure = sites.structure;
  const std::vector<bool> ends = structure.chain_end;
  const auto residue_index = keep_residues(structure, keep);
  move_chain_ends(structure.chain_end, ends, residue_index, structure.atoms.residues.size());
  for (std::uint32_t& residue : structure.atoms.residue_of) residue = residue_index[residue];
  move_atoms(sites, rows);
  reorder(structure.atoms.residue_of, rows);
}

}  // namespace

std::vector<std::uint32_t> choose_atoms(AtomSites& sites, Remarks& remarks) {
  std::vector<std::uint32_t> listed = gather_residues(sites, remarks);
  if (listed.empty()) {
    listed.resize(sites.size());
    std::iota(listed.begin(), listed.end(), std::uint32_t{0});
  }
  std::vector<bool> keep(sites.size(), true);
  drop_dummies(sites, keep, remarks);
  drop_conformers(sites, keep, remarks);
  drop_repeats(sites, keep, remarks);
  std::vector<std::uint32_t> rows, index(sites.size(), left_out);
  for (std::uint32_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    index[listed[i]] = static_cast<std::uint32_t>(rows.size());
    rows.push_back(i);
  }
  if (rows.size() < sites.size()) keep_atoms(sites, keep, rows);
  reorder(listed, rows);
  tell_of_order(sites, listed, remarks);
  return index;
}

void warn_of_placeholders(const AtomSites& sites, Remarks& remarks) {
  constexpr Vec3 placeholder{9999.999, 9999.999, 9999.999};
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (sites.structure.positions[i] != placeholder) continue;
    remarks.warn("placeholder", sites.lines[i], [&] {
      return "atom " + sites.structure.atoms.label(i) +
             " has the placeholder coordinates 9999.999: its place is not known";
    });
  }
}

}  // namespace pliant
