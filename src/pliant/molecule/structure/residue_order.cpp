// SPDX-License-Identifier: MIT
#include "pliant/molecule/structure/residue_order.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <unordered_map>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/molecule/structure/residue_copies.hpp"
#include "pliant/molecule/structure/residue_templates.hpp"

namespace pliant {
namespace {

/// What a residue is to its chain.
enum class Part : std::uint8_t { polymer, water, other };

/// Residues of one chain, and how they stand.
struct Strand {
  std::optional<std::uint32_t> first;  // residue
  std::vector<std::uint32_t> polymer;
  bool is_apart = false;        // heavy atoms of a residue do not stand together
  bool is_interrupted = false;  // others stand between two neighbours
  bool is_shuffled = false;
};

class StrandOrder {
 public:
  /// `leaders`: an atom of each residue, in the order of first atoms.
  StrandOrder(const ListedResidues& listed, const std::vector<std::uint32_t>& leader,
              const std::vector<std::uint32_t>& leaders)
      : listed_(listed),
        leaders_(leaders),
        is_apart_(leader.size(), false),
        is_inside_(leaders.size(), false) {
    constexpr std::uint8_t hydrogen = 1;
    for (std::size_t i = 1; i < leader.size(); ++i)
      if (leader[i] != i && leader[i] != leader[i - 1] && listed.atoms.elements[i] != hydrogen)
        is_apart_[leader[i]] = true;
  }

  /// (R) residues in order; empty if they are in order as they stand.
  std::vector<std::uint32_t> run() {
    find_strands();
    bool changes = false;
    for (Strand& strand : strands_) {
      strand.is_shuffled = is_shuffled(strand);
      changes |= strand.is_shuffled || strand.is_interrupted;
    }
    return changes ? sorted() : std::vector<std::uint32_t>();
  }

 private:
  const Residue& residue(std::uint32_t r) const { return listed_.residue(leaders_[r]); }

  Part part_of(std::uint32_t r) {
    const std::string& name = residue(r).name;
    const auto [at, is_new] = parts_.try_emplace(name, Part::other);
    if (!is_new) return at->second;
    const ResidueTemplate* shape = find_residue_template(name);
    if (shape != nullptr)
      at->second = shape->kind == ResidueKind::water ? Part::water : Part::polymer;
    return at->second;
  }

  void find_strands() {
    std::map<std::tuple<std::uint32_t, std::string_view, std::string_view>, std::uint32_t> known;
    for (std::uint32_t r = 0; r < leaders_.size(); ++r) {
      const std::uint32_t run = listed_.atoms.residue_of[leaders_[r]];
      const std::tuple key{listed_.section(run), std::string_view(residue(r).chain),
                           listed_.segment(run)};
      if (r == 0 || key != last_key_) {
        last_key_ = key;
        last_strand_ =
            known.try_emplace(key, static_cast<std::uint32_t>(known.size())).first->second;
        strands_.resize(known.size());
      }
      strand_of_.push_back(last_strand_);
      parts_of_.push_back(part_of(r));
      take(strands_[last_strand_], r);
    }
  }

  void take(Strand& strand, std::uint32_t r) {
    if (!strand.first) strand.first = r;
    if (parts_of_[r] != Part::polymer) return;
    strand.is_apart |= is_apart_[leaders_[r]];
    const std::uint32_t before = strand.polymer.empty() ? r : strand.polymer.back();
    strand.polymer.push_back(r);
    if (before + 1 >= r || !follow(before, r)) return;
    for (std::uint32_t k = before + 1; k < r; ++k) {
      is_inside_[k] = interrupts(k, before, r);
      strand.is_interrupted |= is_inside_[k];
    }
  }

  /// Whether a residue between two neighbours is none of their chain, as an unknown one with their
  /// numbers is.
  bool interrupts(std::uint32_t r, std::uint32_t before, std::uint32_t after) const {
    const auto [low, high] = std::minmax(residue(before).number, residue(after).number);
    return strand_of_[r] != strand_of_[after] || parts_of_[r] == Part::water ||
           residue(r).number < low || residue(r).number > high;
  }

  /// Also backwards, as some strands of nucleic acids are numbered.
  bool follow(std::uint32_t one, std::uint32_t other) const {
    return std::abs(residue(other).number - residue(one).number) <= 1;
  }

  std::size_t steps_out_of(const Strand& strand, const std::vector<std::uint32_t>& residues) const {
    std::size_t count = 0;
    for (std::size_t k = 1; k < residues.size(); ++k) {
      const bool back = residue(residues[k]).number < residue(residues[k - 1]).number;
      count += !follow(residues[k - 1], residues[k]) || (strand.is_apart && back);
    }
    return count;
  }

  bool is_before(std::uint32_t p, std::uint32_t q) const {
    const Residue& one = residue(p);
    const Residue& other = residue(q);
    return std::tie(one.number, one.insertion_code, p) <
           std::tie(other.number, other.insertion_code, q);
  }

  /// Whether sorting by number would mend most of it; all of it counts where atoms are mixed, too.
  bool is_shuffled(const Strand& strand) const {
    const std::size_t out = steps_out_of(strand, strand.polymer);
    if (out == 0 || (!strand.is_apart && 2 * out < strand.polymer.size())) return false;
    std::vector<std::uint32_t> by_number = strand.polymer;
    std::sort(by_number.begin(), by_number.end(),
              [&](std::uint32_t p, std::uint32_t q) { return is_before(p, q); });
    const std::size_t left = steps_out_of(strand, by_number);
    return strand.is_apart ? left < out : 2 * left < out;
  }

  /// Strands that change stand where their first residue does, what was between their neighbours
  /// after them.
  std::vector<std::uint32_t> sorted() const {
    std::vector<std::uint32_t> order(leaders_.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    const auto place = [&](std::uint32_t r) {
      const Strand& strand = strands_[strand_of_[r]];
      const bool changes = strand.is_shuffled || strand.is_interrupted;
      const bool is_last = strand.is_shuffled ? parts_of_[r] == Part::water
                                              : is_inside_[r] && parts_of_[r] != Part::polymer;
      return std::make_tuple(changes ? *strand.first : r, changes && is_last);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t p, std::uint32_t q) {
      const auto one = place(p), other = place(q);
      if (one != other) return one < other;
      return strands_[strand_of_[p]].is_shuffled ? is_before(p, q) : p < q;
    });
    return order;
  }

  const ListedResidues& listed_;
  const std::vector<std::uint32_t>& leaders_;
  std::vector<Strand> strands_;
  std::vector<std::uint32_t> strand_of_;  // (R)
  std::vector<Part> parts_of_;            // (R)
  std::vector<bool> is_apart_;            // (N) of the first atom of a residue
  std::vector<bool> is_inside_;           // (R) between neighbours of a polymer
  std::unordered_map<std::string_view, Part> parts_;
  std::tuple<std::uint32_t, std::string_view, std::string_view> last_key_;
  std::uint32_t last_strand_ = 0;
};

/// The leaders of all residues, in the order of the list.
std::vector<std::uint32_t> leaders_of(const ResidueCopies& copies) {
  std::vector<std::uint32_t> leaders;
  for (std::uint32_t i = 0; i < copies.leader.size(); ++i)
    if (copies.leader[i] == i) leaders.push_back(i);
  return leaders;
}

}  // namespace

ResidueOrder order_residues(const ListedResidues& listed) {
  ResidueCopies copies = residue_copies(listed);
  ResidueOrder made;
  made.by_distance = std::move(copies.by_distance);
  made.leaders = leaders_of(copies);
  const std::vector<std::uint32_t> sorted = StrandOrder(listed, copies.leader, made.leaders).run();
  if (!sorted.empty()) {
    std::vector<std::uint32_t> leaders;
    for (const std::uint32_t r : sorted) leaders.push_back(made.leaders[r]);
    made.leaders = std::move(leaders);
  }
  const std::size_t count = copies.leader.size();
  std::vector<std::uint32_t> residue_at(count, 0);  // of a leader
  for (std::uint32_t r = 0; r < made.leaders.size(); ++r) residue_at[made.leaders[r]] = r;
  const Grouped<std::uint32_t> atoms(made.leaders.size(), [&](const auto& put) {
    for (std::uint32_t i = 0; i < count; ++i) put(residue_at[copies.leader[i]], i);
  });
  made.order.assign(atoms.things().begin(), atoms.things().end());
  for (const std::uint32_t atom : made.order)
    made.residue_of.push_back(residue_at[copies.leader[atom]]);
  return made;
}

void reorder_atoms(Structure& structure, const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(structure.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  reorder(structure.atoms.names, order);
  reorder(structure.atoms.elements, order);
  reorder(structure.atoms.serials, order);
  reorder(structure.positions, order);
  reorder(structure.charges, order);
  reorder(structure.isotopes, order);
  reorder(structure.radicals, order);
  reorder(structure.b_factors, order);
  for (Bond& bond : structure.bonds)
    std::tie(bond.a, bond.b) = std::minmax({place[bond.a], place[bond.b]});
  std::sort(structure.bonds.begin(), structure.bonds.end(),
            [](const Bond& p, const Bond& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); });
}

void gather_residues(Structure& structure, const Log& log) {
  AtomTable& atoms = structure.atoms;
  ResidueOrder made = order_residues({atoms, structure.positions, {}, {}, {}, {}});
  if (std::is_sorted(made.order.begin(), made.order.end())) return;
  std::vector<Residue> residues;
  for (const std::uint32_t atom : made.leaders)
    residues.push_back(atoms.residues[atoms.residue_of[atom]]);
  atoms.residues = std::move(residues);
  atoms.residue_of = std::move(made.residue_of);
  structure.chain_end.clear();
  reorder_atoms(structure, made.order);
  structure.source_order = std::move(made.order);
  log.note("atoms of a residue stand apart: they are put together, in another order than given");
}

}  // namespace pliant
