// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/bonds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/molecule/bonds/distance_bonds.hpp"
#include "pliant/molecule/bonds/link_bonds.hpp"
#include "pliant/molecule/bonds/make_whole.hpp"
#include "pliant/molecule/bonds/perception.hpp"
#include "pliant/molecule/bonds/stated_bonds.hpp"
#include "pliant/molecule/bonds/template_bonds.hpp"
#include "pliant/molecule/bonds/valence.hpp"
#include "pliant/molecule/read/read.hpp"

namespace pliant {
namespace {

using perception::Perception;
using perception::Tally;

// Beyond this (Angstrom) neighbouring doubles are 1e-4 apart: bond lengths lose their meaning.
constexpr double farthest = 1e12;

void check_positions(const Structure& structure) {
  if (structure.positions.size() != structure.atoms.size())
    throw InputError("structure: " + std::to_string(structure.atoms.size()) + " atoms but " +
                     std::to_string(structure.positions.size()) + " positions");
  for (std::size_t i = 0; i < structure.size(); ++i) {
    const Vec3 p = structure.positions[i];
    if (is_finite(p) && std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= farthest)
      continue;
    throw InputError(
        "position of " + structure.atoms.label(i) +
        (is_finite(p) ? " is more than 1e12 Angstrom from the origin" : " is not a finite number"));
  }
}

/// "1 atom", "3 atoms".
std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

void warn(const Log& log, const Tally& tally, std::string_view noun, std::string_view what) {
  if (tally.count == 0) return;
  log.warn(counted(tally.count, noun) + " (first: " + tally.first + ") " + std::string(what));
}

/// "A:SER1:CA - A:LYS6:CA (5.90 Angstrom)", four of them at most.
std::string listed(const Structure& structure, const std::vector<Bond>& bonds) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, bonds.size()); ++k) {
    const Bond& bond = bonds[k];
    char length[48];
    std::snprintf(length, sizeof length, " (%.2f Angstrom)",
                  distance(structure.positions[bond.a], structure.positions[bond.b]));
    text += (k > 0 ? ", " : "") + structure.atoms.label(bond.a) + " - " +
            structure.atoms.label(bond.b) + length;
  }
  if (bonds.size() > most) text += " and " + std::to_string(bonds.size() - most) + " more";
  return text;
}

/// Bonds of the file that no other step found.
std::vector<Bond> lost(const Perception& perception) {
  std::vector<Bond> bonds = perception.long_out;
  const auto is_before = [](const Bond& one, const Bond& other) {
    return one.a != other.a ? one.a < other.a : one.b < other.b;
  };
  std::erase_if(bonds, [&](const Bond& bond) {
    return std::ranges::binary_search(perception.bonds, bond, is_before);
  });
  return bonds;
}

void tell_of_stated(const Perception& perception, const Log& log) {
  const auto warn_of = [&](const std::vector<Bond>& bonds, const std::string& what) {
    if (!bonds.empty())
      log.warn(counted(bonds.size(), "bond") + what + ": " + listed(perception.structure, bonds));
  };
  const std::string is_long =
      " stated by the file, longer than 1.3 times the sum of covalent radii, ";
  warn_of(lost(perception), is_long + "left out");
  warn_of(perception.long_kept, is_long + "kept");
  warn_of(perception.unheld,
          " of metals stated by the file, longer than coordination is, not held");
}

/// Atoms whose element nobody knows and that no bond reaches.
Tally unknown_atoms(const Structure& structure) {
  std::vector<bool> bonded(structure.size(), false);
  for (const Bond& bond : structure.bonds) bonded[bond.a] = bonded[bond.b] = true;
  Tally tally;
  for (std::size_t i = 0; i < structure.size(); ++i)
    if (!bonded[i] && structure.atoms.elements[i] == 0)
      tally.add([&] { return structure.atoms.label(i); });
  return tally;
}

/// Atoms with more neighbours than their element has, which residues and links give them.
Tally overfull_atoms(const Structure& structure) {
  std::vector<std::uint32_t> neighbours(structure.size(), 0);
  for (const Bond& bond : structure.bonds) {
    if (is_metal(structure.atoms.elements[bond.a]) || is_metal(structure.atoms.elements[bond.b]))
      continue;
    ++neighbours[bond.a];
    ++neighbours[bond.b];
  }
  Tally tally;
  for (std::size_t i = 0; i < structure.size(); ++i) {
    const std::uint8_t element = structure.atoms.elements[i];
    if (element != 0 && neighbours[i] > perception::most_neighbours(element))
      tally.add([&] { return structure.atoms.label(i); });
  }
  return tally;
}

void warn_of_doubts(const Perception& perception, const Log& log) {
  const Structure& structure = perception.structure;
  warn(log, perception.unplaced, "atom", "at placeholder coordinates: no bonds perceived there");
  warn(log, perception.repeated, "atom",
       "on top of an atom of the same name: no bonds perceived there");
  warn(log, perception.stretched, "bond",
       "of residue templates too long to be true: left out (is the molecule cut by a periodic "
       "box?)");
  tell_of_stated(perception, log);
  warn(log, perception.crowded, "atom",
       "where atoms crowd: no bonds guessed there (are the coordinates in Angstrom?)");
  if (!is_from(structure, &Format::has_small_molecules))
    warn(log, overfull_atoms(structure), "atom", "with more bonds than such atoms have");
  warn(log, unknown_atoms(structure), "atom", "of unknown element without bonds");
}

void take_steps(Perception& steps) {
  const Structure& structure = steps.structure;
  perception::judge_stated_bonds(steps);
  // All bonds of such a file are stated: nothing is left to guess, and a drawing's distances lie.
  if (!is_from(structure, &Format::has_small_molecules) || structure.bonds.empty()) {
    add_template_bonds(steps);
    add_links(steps);
    perception::sort_and_merge(steps.bonds, structure.size());
    if (steps.options.guess_distances) add_distance_bonds(steps);
  }
  perception::sort_and_merge(steps.bonds, structure.size());
}

void finish(Structure& structure, Perception& steps) {
  structure.bonds = steps.bonds;
  warn_of_doubts(steps, steps.options.log);
}

}  // namespace

void perceive_bonds(Structure& structure, const BondOptions& options) {
  check_positions(structure);
  Perception steps(structure, options);
  take_steps(steps);
  if (!perception::make_whole(structure, steps)) return finish(structure, steps);
  Perception again(structure, options);
  take_steps(again);
  finish(structure, again);
}

bool make_whole(Structure& structure, const Log& log) {
  check_positions(structure);
  BondOptions options;
  options.guess_distances = false;
  options.log = log;
  Perception steps(structure, options);
  return perception::make_whole(structure, steps);
}

}  // namespace pliant
