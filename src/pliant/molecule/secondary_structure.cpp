// SPDX-License-Identifier: MIT
#include "pliant/molecule/secondary_structure.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "pliant/base/math/cell_list.hpp"

namespace pliant {
namespace {

constexpr double charges = 0.084 * 332.0;  // kcal/mol Angstrom
constexpr double weakest = -0.5;           // kcal/mol
constexpr double farthest = 5.0;           // Angstrom, N..O
constexpr double hydrogen_length = 1.01;   // Angstrom
constexpr std::uint32_t none = ~std::uint32_t{0};
enum Part : std::uint8_t { nitrogen, alpha, carbonyl, oxygen, part_count };
using Parts = std::array<std::uint32_t, part_count>;

Vec3 unit(Vec3 a) { return 1.0 / norm(a) * a; }

std::uint8_t part_of(std::string_view name, std::uint8_t element) {
  if (name == "N" && element == 7) return nitrogen;
  if (name == "CA" && element == 6) return alpha;
  if (name == "C" && element == 6) return carbonyl;
  if ((name == "O" || name == "O1" || name == "OT1") && element == 8) return oxygen;
  return part_count;
}

std::vector<Parts> parts_of(const AtomTable& atoms) {
  std::vector<Parts> parts(atoms.residues.size(), Parts{none, none, none, none});
  for (std::uint32_t k = 0; k < atoms.size(); ++k) {
    const std::uint8_t part = part_of(atoms.names[k], atoms.elements[k]);
    if (part < part_count) parts[atoms.residue_of[k]][part] = k;
  }
  return parts;
}

/// The residues that have a backbone, one after the other, and their hydrogen bonds.
class Backbone {
 public:
  Backbone(const AtomTable& atoms, std::span<const Vec3> positions) {
    const std::vector<Parts> parts = parts_of(atoms);
    for (std::uint32_t k = 0; k < parts.size(); ++k)
      if (std::ranges::count(parts[k], none) == 0) {
        residues_.push_back(k);
        donates_.push_back(atoms.residues[k].name != "PRO");
        for (std::size_t c = 0; c < part_count; ++c) at_[c].push_back(positions[parts[k][c]]);
      }
    donors_.resize(size());
    if (size() > 1) find_bonds();
  }

  std::size_t size() const { return residues_.size(); }
  std::uint32_t residue(std::size_t k) const { return residues_[k]; }

  /// Whether the C=O of one is bonded to the N-H of the other; not where a number is outside.
  bool is_bonded(std::size_t acceptor, std::size_t donor) const {
    return acceptor < size() && std::ranges::count(donors_[acceptor], donor) > 0;
  }

  template <class Visit>
  void for_each_bond(const Visit& visit) const {
    for (std::size_t acceptor = 0; acceptor < size(); ++acceptor)
      for (const std::size_t donor : donors_[acceptor]) visit(acceptor, donor);
  }

 private:
  /// The first N-H and the last C=O are not looked at.
  void find_bonds() {
    const std::size_t pairs = size() - 1;
    std::vector<Vec3> points(at_[nitrogen].begin() + 1, at_[nitrogen].end());
    points.insert(points.end(), at_[oxygen].begin(), at_[oxygen].end() - 1);
    CellList(points, farthest).for_each_pair([&](std::size_t i, std::size_t j, double) {
      if (i < pairs && j >= pairs) consider(j - pairs, i + 1);
    });
  }

  void consider(std::size_t acceptor, std::size_t donor) {
    const bool is_near = donor >= acceptor && donor - acceptor <= 2;
    if (!is_near && donates_[donor] && energy(acceptor, donor) < weakest)
      donors_[acceptor].push_back(donor);
  }

  Vec3 hydrogen(std::size_t k) const {
    const Vec3 n = at_[nitrogen][k];
    return n + hydrogen_length * unit(unit(n - at_[carbonyl][k - 1]) + unit(n - at_[alpha][k]));
  }

  double energy(std::size_t acceptor, std::size_t donor) const {
    const Vec3 n = at_[nitrogen][donor], h = hydrogen(donor);
    const Vec3 c = at_[carbonyl][acceptor], o = at_[oxygen][acceptor];
    return charges * (1.0 / distance(o, n) + 1.0 / distance(c, h) - 1.0 / distance(o, h) -
                      1.0 / distance(c, n));
  }

  std::vector<std::uint32_t> residues_;
  std::vector<bool> donates_;
  std::array<std::vector<Vec3>, part_count> at_;
  std::vector<std::vector<std::size_t>> donors_;  ///< of each acceptor
};

using Flags = std::vector<bool>;

/// Where two turns of `width` follow each other.
Flags double_turns(const Backbone& backbone, std::size_t width) {
  Flags found(backbone.size());
  for (std::size_t k = 1; k < found.size(); ++k)
    found[k] = backbone.is_bonded(k - 1, k - 1 + width) && backbone.is_bonded(k, k + width);
  return found;
}

/// Each `width` residues long.
Flags helices(const Flags& begins, std::size_t width) {
  Flags found(begins.size());
  for (std::size_t k = 0; k < begins.size(); ++k)
    for (std::size_t j = k; begins[k] && j < std::min(k + width, begins.size()); ++j)
      found[j] = true;
  return found;
}

/// Alpha goes before the others.
Flags outside(Flags begins, const Flags& alpha_helix) {
  for (std::size_t k = 0; k < begins.size(); ++k)
    if (alpha_helix[k] || (k + 1 < begins.size() && alpha_helix[k + 1])) begins[k] = false;
  return begins;
}

/// Residues of bridges: parallel, and antiparallel in two ways.
Flags bridged(const Backbone& backbone) {
  Flags found(backbone.size());
  const auto mark = [&](std::size_t i, std::size_t j) { found[i] = found[j] = true; };
  backbone.for_each_bond([&](std::size_t acceptor, std::size_t donor) {
    if (backbone.is_bonded(donor, acceptor + 2)) mark(acceptor + 1, donor);
    if (backbone.is_bonded(donor, acceptor)) mark(acceptor, donor);
    if (donor >= 2 && backbone.is_bonded(donor - 2, acceptor + 2)) mark(acceptor + 1, donor - 1);
  });
  return found;
}

}  // namespace

std::string secondary_structure(const AtomTable& atoms, std::span<const Vec3> positions) {
  const Backbone backbone(atoms, positions);
  const Flags four = helices(double_turns(backbone, 4), 4);
  const Flags three = helices(outside(double_turns(backbone, 3), four), 3);
  const Flags five = helices(outside(double_turns(backbone, 5), four), 5);
  const Flags strand = bridged(backbone);
  std::string letters(atoms.residues.size(), ' ');
  for (std::size_t k = 0; k < backbone.size(); ++k)
    letters[backbone.residue(k)] = three[k] || four[k] || five[k] ? 'H' : strand[k] ? 'E' : '-';
  return letters;
}

}  // namespace pliant
