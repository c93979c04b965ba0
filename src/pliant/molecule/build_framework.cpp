// SPDX-License-Identifier: MIT
#include "pliant/molecule/build_framework.hpp"

#include <algorithm>
#include <cstdio>

#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/molecule/bonds/cut_bonds.hpp"
#include "pliant/molecule/planar_groups.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/molecule/stated_bars.hpp"

namespace pliant {
namespace {

// Coordinates in files have three or four decimals: two atoms nearer than this are at one point.
constexpr double zero_length = 1e-4;

// Atoms with more bonds than any element has are no matter for bars between all their neighbours.
constexpr std::size_t most_neighbours = 64;

/// Message about `structure`: with the file's name where there is one.
[[noreturn]] void refuse(const Structure& structure, const std::string& message) {
  throw InputError(structure.source.empty() ? message : at({structure.source}, message));
}

class FrameworkBuilder {
 public:
  FrameworkBuilder(const Structure& structure, const BuildOptions& options)
      : structure_(structure), options_(options) {}

  FrameworkParts parts() {
    parts_.joint_count = structure_.size();
    parts_.atoms = std::make_shared<const AtomTable>(structure_.atoms);
    if (options_.bars != BarKind::none) add_bonds();
    if (options_.bars == BarKind::angles) add_angles();
    if (options_.bars == BarKind::angles) add_planar_groups();
    add_stated();
    if (is_drawn()) parts_.drawn = structure_.positions;
    if (options_.use_masses) add_masses();
    if (!options_.pin.empty()) pin();
    parts_.limits = options_.limits;
    parts_.sterics = options_.sterics;
    parts_.torsion_preferences = options_.torsion_preferences;
    return std::move(parts_);
  }

 private:
  void add_bonds() {
    for (const Bond& bond : structure_.bonds) {
      check_atom(bond.a);
      check_atom(bond.b);
    }
    for (const Bond& bond : structure_.bonds) {
      parts_.bars.push_back({bond.a, bond.b});
      parts_.rest_lengths.push_back(measured_length(bond.a, bond.b));
    }
  }

  void check_atom(std::uint32_t atom) const {
    if (atom >= structure_.size())
      refuse(structure_, "a bond names atom " + std::to_string(atom) + " of " +
                             std::to_string(structure_.size()) + " (counted from 0)");
  }

  std::string label(std::uint32_t a, std::uint32_t b) const {
    return structure_.atoms.label(a) + " - " + structure_.atoms.label(b);
  }

  double measured_length(std::uint32_t a, std::uint32_t b) const {
    const double length = distance(structure_.positions[a], structure_.positions[b]);
    if (length >= zero_length) return length;
    char text[128];
    const Vec3 p = structure_.positions[a];
    std::snprintf(text, sizeof text, "(%.3f, %.3f, %.3f)", p.x, p.y, p.z);
    refuse(structure_,
           "bar " + label(a, b) + " has length 0: both atoms are at " + std::string(text));
  }

  /// A bar between each two neighbours of an atom that are not bonded themselves; pairs that meet
  /// at two atoms (four-membered rings) once.
  void add_angles() {
    index_neighbours();
    std::vector<Bar> across;
    for (std::uint32_t centre = 0; centre < structure_.size(); ++centre) {
      const auto first = first_neighbour_[centre], last = first_neighbour_[centre + 1];
      if (last - first > most_neighbours)
        refuse(structure_,
               "atom " + structure_.atoms.label(centre) + " has " + std::to_string(last - first) +
                   " bonds: bars across angles are for at most " + std::to_string(most_neighbours));
      for (auto j = first; j < last; ++j)
        for (auto k = j + 1; k < last; ++k)
          if (!are_bonded(neighbours_[j], neighbours_[k]))
            across.push_back({std::min(neighbours_[j], neighbours_[k]),
                              std::max(neighbours_[j], neighbours_[k])});
    }
    const auto key = [](Bar bar) { return std::uint64_t{bar.a} << 32 | bar.b; };
    std::sort(across.begin(), across.end(), [&](Bar x, Bar y) { return key(x) < key(y); });
    across.erase(std::unique(across.begin(), across.end()), across.end());
    for (Bar bar : across) {
      parts_.bars.push_back(bar);
      parts_.rest_lengths.push_back(measured_length(bar.a, bar.b));
    }
  }

  /// Bars across the torsions of bonds about which nothing turns.
  void add_planar_groups() {
    for (Bar bar : find_planar_bars(structure_)) {
      parts_.bars.push_back(bar);
      parts_.rest_lengths.push_back(measured_length(bar.a, bar.b));
    }
  }

  /// Stated bars, each in the place of the bar that its atoms have, if they have one.
  void add_stated() {
    for (const StatedBar& stated : options_.stated) {
      check_atom(stated.bar.a);
      check_atom(stated.bar.b);
    }
    pliant::add_stated(
        options_.stated, [this](Bar bar) { return measured_length(bar.a, bar.b); }, parts_);
  }

  /// Whether the structure shows every bar at its rest length.
  bool is_drawn() const {
    return std::none_of(options_.stated.begin(), options_.stated.end(),
                        [](const StatedBar& bar) { return bar.length.has_value(); });
  }

  void index_neighbours() {
    first_neighbour_.assign(structure_.size() + 1, 0);
    for (Bar bar : parts_.bars) {
      ++first_neighbour_[bar.a + 1];
      ++first_neighbour_[bar.b + 1];
    }
    for (std::size_t i = 0; i < structure_.size(); ++i)
      first_neighbour_[i + 1] += first_neighbour_[i];
    neighbours_.resize(2 * parts_.bars.size());
    std::vector<std::size_t> next(first_neighbour_.begin(), first_neighbour_.end() - 1);
    for (Bar bar : parts_.bars) {
      neighbours_[next[bar.a]++] = bar.b;
      neighbours_[next[bar.b]++] = bar.a;
    }
  }

  bool are_bonded(std::uint32_t a, std::uint32_t b) const {
    const auto first = neighbours_.begin() + first_neighbour_[a];
    const auto last = neighbours_.begin() + first_neighbour_[a + 1];
    return a == b || std::find(first, last, b) != last;
  }

  void add_masses() {
    parts_.masses.reserve(structure_.size());
    for (std::uint8_t element : structure_.atoms.elements)
      parts_.masses.push_back(element_mass(element));
  }

  void pin() { parts_.pinned = select_some_atoms(structure_.atoms, options_.pin, "pin"); }

  const Structure& structure_;
  const BuildOptions& options_;
  FrameworkParts parts_;
  std::vector<std::size_t> first_neighbour_;
  std::vector<std::uint32_t> neighbours_;
};

}  // namespace

Framework build_framework(const Structure& structure, const BuildOptions& options) {
  if (!options.may_be_cut && options.bars != BarKind::none) refuse_cut(structure);
  FrameworkParts parts = FrameworkBuilder(structure, options).parts();
  if (options.stated_in.empty()) return Framework(std::move(parts));
  try {
    return Framework(std::move(parts));
  } catch (const InputError& error) {
    throw InputError(at({options.stated_in}, error.what()));
  }
}

}  // namespace pliant
