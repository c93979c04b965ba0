// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/link_bonds.hpp"

#include <algorithm>
#include <array>

#include "pliant/base/math/cell_list.hpp"

namespace pliant::perception {
namespace {

// Disulphides are 2.05 Angstrom long.
constexpr double longest_disulphide = 2.5;

const AtomKey name_c = atom_key("C", false), name_n = atom_key("N", false),
              name_ca = atom_key("CA", false), name_oxt = atom_key("OXT", false),
              name_o3 = atom_key("O3'", false), name_p = atom_key("P", false),
              name_sg = atom_key("SG", false);

/// The atoms by which a piece is linked; the size of the structure where there is none.
struct Ends {
  std::uint32_t head;   ///< N or P: bonds to the piece before
  std::uint32_t tail;   ///< C or O3': bonds to the piece after
  bool tail_is_closed;  ///< has OXT
};

class LinkStep {
 public:
  explicit LinkStep(Perception& perception)
      : p_(perception), none_(static_cast<std::uint32_t>(perception.structure.size())) {}

  void run() {
    const std::size_t none = p_.pieces.size();
    std::size_t begin = none, before = none;  // of the row of linked pieces: its first, its last
    for (std::size_t k = 0; k < p_.pieces.size(); ++k) {
      ends_.push_back(ends_of(p_.pieces[k]));
      if (is_water(p_.pieces[k])) continue;  // may stand between two that are linked
      if (before == none || !link(before, k)) {
        if (before != none) close_ring(begin, before);
        begin = k;
      }
      before = k;
    }
    if (before != none) close_ring(begin, before);
    add_disulphides();
  }

 private:
  static bool is_water(const ResiduePiece& piece) {
    return piece.shape && piece.shape->kind == ResidueKind::water;
  }

  Ends ends_of(const ResiduePiece& piece) const {
    const ResidueKind kind = piece.shape ? piece.shape->kind : ResidueKind::amino_acid;
    if (is_water(piece)) return {none_, none_, false};
    if (kind == ResidueKind::nucleotide)
      return {p_.find(piece, name_p), p_.find(piece, name_o3), false};
    Ends ends{p_.find(piece, name_n), p_.find(piece, name_c), false};
    ends.tail_is_closed = p_.exists(p_.find(piece, name_oxt));
    const bool whole = p_.exists(ends.head) && p_.exists(ends.tail);
    // An unknown residue counts as one of a peptide if it has that backbone.
    if (!piece.shape && !(whole && p_.exists(p_.find(piece, name_ca))))
      return {none_, none_, false};
    // The C of a cap that has an N is its methyl group.
    if (kind == ResidueKind::cap && whole) ends.tail = none_;
    return ends;
  }

  bool can_link(std::uint32_t a, std::uint32_t b) const {
    return p_.exists(a) && p_.exists(b) && !p_.excluded[a] && !p_.excluded[b];
  }

  bool are_close(std::uint32_t a, std::uint32_t b) const {
    if (!can_link(a, b)) return false;
    const double length = p_.length(a, b);
    return length > p_.options.shortest && length < longest_link;
  }

  /// A piece of an unknown residue may only be linked to one of a known residue: between two of
  /// them distances decide.
  bool link(std::size_t before, std::size_t after) {
    const ResiduePiece& one = p_.pieces[before];
    const ResiduePiece& other = p_.pieces[after];
    const auto& atoms = p_.structure.atoms;
    const std::uint32_t residue = atoms.residue_of[one.first];
    const std::uint32_t next = atoms.residue_of[other.first];
    if (!one.shape && !other.shape) return false;
    if (kind(one) != kind(other) || atoms.residues[residue].chain != atoms.residues[next].chain)
      return false;
    const auto& ends = p_.structure.chain_end;
    if (residue != next && residue < ends.size() && ends[residue]) return false;
    const std::uint32_t tail = ends_[before].tail, head = ends_[after].head;
    if (!are_close(tail, head)) {
      if (can_link(tail, head)) p_.parted_links.push_back({tail, head, BondOrigin::link, 1});
      return false;
    }
    p_.add(tail, head, BondOrigin::link, 1);
    return true;
  }

  /// Nucleotides link among themselves; amino acids, caps and unknown residues among themselves.
  static bool kind(const ResiduePiece& piece) {
    return piece.shape && piece.shape->kind == ResidueKind::nucleotide;
  }

  /// Head to tail, for cyclic peptides and nucleic acids.
  void close_ring(std::size_t first, std::size_t last) {
    if (first == last || ends_[last].tail_is_closed) return;
    if (are_close(ends_[last].tail, ends_[first].head))
      p_.add(ends_[last].tail, ends_[first].head, BondOrigin::link, 1);
  }

  /// Sulphur atoms of cysteines without a hydrogen.
  std::vector<std::uint32_t> free_sulphurs() const {
    const AtomKey hydrogens[] = {atom_key("HG", false), atom_key("HG1", false)};
    std::vector<std::uint32_t> atoms;
    for (const ResiduePiece& piece : p_.pieces) {
      if (!piece.shape || piece.shape->kind != ResidueKind::amino_acid) continue;
      const std::uint32_t sulphur = p_.find(piece, name_sg);
      const bool thiol = std::any_of(std::begin(hydrogens), std::end(hydrogens),
                                     [&](AtomKey key) { return p_.exists(p_.find(piece, key)); });
      if (p_.exists(sulphur) && !thiol && !p_.excluded[sulphur]) atoms.push_back(sulphur);
    }
    return atoms;
  }

  /// Nearest pairs first, one bond a sulphur atom.
  void add_disulphides() {
    struct Bridge {
      double squared;
      std::uint32_t a, b;
      auto operator<=>(const Bridge&) const = default;
    };
    const std::vector<std::uint32_t> sulphurs = free_sulphurs();
    std::vector<Vec3> positions;
    for (std::uint32_t atom : sulphurs) positions.push_back(p_.structure.positions[atom]);
    std::vector<Bridge> candidates;
    CellList(positions, longest_disulphide)
        .for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
          if (squared > p_.options.shortest * p_.options.shortest)
            candidates.push_back({squared, sulphurs[i], sulphurs[j]});
        });
    std::sort(candidates.begin(), candidates.end());
    std::vector<bool> taken(p_.structure.size(), false);
    for (const Bridge& pair : candidates) {
      if (taken[pair.a] || taken[pair.b]) continue;
      taken[pair.a] = taken[pair.b] = true;
      p_.add(pair.a, pair.b, BondOrigin::link, 1);
    }
  }

  Perception& p_;
  std::uint32_t none_;
  std::vector<Ends> ends_;  ///< by piece
};

}  // namespace

void add_links(Perception& perception) { LinkStep(perception).run(); }

}  // namespace pliant::perception
