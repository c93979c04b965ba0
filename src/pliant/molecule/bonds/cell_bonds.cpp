// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/cell_bonds.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/elements.hpp"
#include "pliant/base/math/cell_list.hpp"

namespace pliant::perception {
namespace {

// Wider than the sum of two radii of elements that bond by distance, and the usual slack.
constexpr double longest_by_distance = 4.0;

// In units of the edges: positions so far away have lost their decimals.
constexpr double farthest_part = 1e6;

/// An atom, or an image of it near a face, in the cell that begins at the origin.
struct Image {
  std::uint32_t atom;
  CellShift shift;  ///< from where the atom is
};

class CellStep {
 public:
  explicit CellStep(const Perception& perception)
      : p_(perception), images_(*perception.structure.cell) {}

  std::vector<CellBond> find() {
    for (const Bond& bond : p_.bonds)
      if (bond.origin == BondOrigin::file && p_.length(bond.a, bond.b) > longest_stated)
        add(bond.a, bond.b, longest_stated);
    for (const Bond& bond : p_.long_out)
      if (p_.length(bond.a, bond.b) > longest_stated) add(bond.a, bond.b, longest_stated);
    for (const Bond& bond : p_.stretched_bonds) add(bond.a, bond.b, longest_of_template(bond));
    for (const Bond& bond : p_.parted_links) add(bond.a, bond.b, longest_link);
    if (p_.options.guess_distances) add_by_distance();
    return std::move(found_);
  }

 private:
  double longest_of_template(const Bond& bond) const {
    return longest_template_bond(p_.structure, bond.a, bond.b);
  }

  void add(std::uint32_t a, std::uint32_t b, double longest) {
    const Vec3 difference = p_.structure.positions[b] - p_.structure.positions[a];
    const CellShift shift = images_.to_nearest(difference);
    const double length = norm(difference + images_.cell()(shift));
    if (shift != no_shift && length <= longest && length > p_.options.shortest)
      found_.push_back({a, b, shift});
  }

  /// Atoms that templates do not settle, of residues that are more than an ion.
  std::vector<std::uint32_t> open_atoms() const {
    std::vector<std::uint32_t> atoms;
    const auto& elements = p_.structure.atoms.elements;
    for (const ResiduePiece& piece : p_.pieces) {
      if (piece.last - piece.first == 1) continue;
      for (std::uint32_t atom = piece.first; atom < piece.last; ++atom)
        if (!p_.settled[atom] && !p_.excluded[atom] && covalent_radius(elements[atom]) > 0.0 &&
            !is_metal(elements[atom]))
          atoms.push_back(atom);
    }
    return atoms;
  }

  /// Moves an atom into the cell at the origin, and adds its images beyond the faces it is near.
  void add_images(std::uint32_t atom, std::vector<Image>& images, std::vector<Vec3>& points) const {
    const Vec3 position = p_.structure.positions[atom];
    const Vec3 part = images_.fractions(position);
    const double parts[] = {part.x, part.y, part.z};
    CellShift into;
    std::array<std::array<bool, 3>, 3> taken{};  ///< by axis: one edge back, none, one forward
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(std::abs(parts[k]) < farthest_part)) return;
      into[k] = -static_cast<std::int32_t>(std::floor(parts[k]));
      const double margin = longest_by_distance / images_.widths()[k];
      taken[k] = {parts[k] + into[k] > 1.0 - margin, true, parts[k] + into[k] < margin};
    }
    for (std::int32_t x = 0; x < 3; ++x)
      for (std::int32_t y = 0; y < 3; ++y)
        for (std::int32_t z = 0; z < 3; ++z) {
          if (!taken[0][x] || !taken[1][y] || !taken[2][z]) continue;
          const CellShift shift{into[0] + x - 1, into[1] + y - 1, into[2] + z - 1};
          images.push_back({atom, shift});
          points.push_back(position + images_.cell()(shift));
        }
  }

  void add_by_distance() {
    std::vector<Image> images;
    std::vector<Vec3> points;
    for (std::uint32_t atom : open_atoms()) add_images(atom, images, points);
    CellList(points, longest_by_distance)
        .for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
          add_pair(images[i], images[j], std::sqrt(squared));
        });
  }

  /// Each pair comes up several times, which does no harm. Only atoms of one residue: the next
  /// molecule of a crystal may touch.
  void add_pair(Image one, Image other, double length) {
    if (one.atom > other.atom) std::swap(one, other);
    const auto& residue_of = p_.structure.atoms.residue_of;
    if (one.atom == other.atom || residue_of[one.atom] != residue_of[other.atom]) return;
    CellShift shift;
    for (std::size_t k = 0; k < 3; ++k) shift[k] = other.shift[k] - one.shift[k];
    if (shift != no_shift && can_be_bonded(one.atom, other.atom, length))
      found_.push_back({one.atom, other.atom, shift});
  }

  bool can_be_bonded(std::uint32_t a, std::uint32_t b, double length) const {
    const auto& elements = p_.structure.atoms.elements;
    if (elements[a] == 1 && elements[b] == 1) return false;
    const double radii = covalent_radius(elements[a]) + covalent_radius(elements[b]);
    return length > p_.options.shortest && length <= radii + p_.options.slack;
  }

  const Perception& p_;
  CellImages images_;
  std::vector<CellBond> found_;
};

}  // namespace

std::vector<CellBond> cell_bonds(const Perception& perception) {
  return CellStep(perception).find();
}

}  // namespace pliant::perception
