// SPDX-License-Identifier: MIT
#include "pliant/sample/loops/loop_moves.hpp"

#include <algorithm>

#include "pliant/base/math/elementary.hpp"
#include "pliant/sample/loops/loop_draw.hpp"

namespace pliant {
namespace {

// Loops by e^(-a n) for n contacts a residue; none with more, as helices and sheets have.
constexpr double of_contacts = 6.0, most_contacts = 1.0;

constexpr std::size_t least_turns = 9;   // torsions: six close the loop
constexpr int most_draws = 40;           // of one loop, until it fits
constexpr std::size_t most_choices = 6;  // of loops, for each that is wanted
constexpr double most_overlap = 0.7;     // Angstrom: resolving takes away less

bool have_common(const LoopSegment& one, const LoopSegment& other) {
  return one.first < other.last && other.first < one.last;
}

}  // namespace

LoopMoves::LoopMoves(const Framework& framework, const BodyPlan& plan, std::span<const Vec3> start,
                     const std::vector<bool>& in_place)
    : framework_(framework), start_(start) {
  if (framework.atoms() == nullptr) return;
  residues_ = loop_residues(framework, plan, start);
  find_segments(in_place);
  if (framework.sterics() == nullptr) return;
  rules_.emplace(framework);
  find_backbone();
}

void LoopMoves::find_segments(const std::vector<bool>& in_place) {
  double sum = 0.0;
  for (std::size_t first = 0; first < residues_.size(); ++first) {
    double contacts = 0.0;
    std::size_t turns = 0;
    bool is_near = in_place.empty();
    for (std::size_t k = first; k < residues_.size() && k - first < longest_loop; ++k) {
      const LoopResidue& one = residues_[k];
      if (one.is_held || !one.is_linked_before || !one.is_linked_behind) break;
      contacts += one.contacts;
      turns += std::size_t{one.has_phi} + std::size_t{one.has_psi};
      is_near = is_near || in_place[one.residue];
      const std::size_t length = k + 1 - first;
      const double mean = contacts / double(length);
      if (length < shortest_loop || turns < least_turns || !is_near || mean > most_contacts)
        continue;
      segments_.push_back({first, k + 1});
      weights_.push_back(sum += exact_bits_exp(-of_contacts * mean));
    }
  }
}

/// Side chains from CB on and hydrogens get out of the way; ligands do not.
void LoopMoves::find_backbone() {
  constexpr std::uint8_t hydrogen = 1;
  const AtomTable& atoms = *framework_.atoms();
  std::vector<bool> is_side_chain(atoms.size(), false);
  for (const LoopResidue& one : residues_)
    for (const Joint joint : one.parts[1])
      is_side_chain[joint] = joint != one.c && atoms.names[joint] != "CB";
  for (Joint k = 0; k < atoms.size(); ++k) {
    is_backbone_.push_back(!is_side_chain[k] && atoms.elements[k] != hydrogen);
    if (is_backbone_[k]) backbone_.push_back(k);
  }
}

const LoopSegment& LoopMoves::choose(RandomSequence& draws) const {
  const auto at = std::ranges::upper_bound(weights_, draws.uniform() * weights_.back());
  return segments_[std::min(static_cast<std::size_t>(at - weights_.begin()), segments_.size() - 1)];
}

std::vector<LoopSegment> LoopMoves::redraw(RandomSequence& draws, std::size_t most,
                                           std::span<Vec3> x) const {
  std::vector<LoopSegment> done;
  if (empty() || most == 0) return done;
  const std::size_t wanted = 1 + draws.below(most);
  for (std::size_t k = 0; k < most_choices * wanted && done.size() < wanted; ++k) {
    const LoopSegment& segment = choose(draws);
    const bool is_new = std::ranges::none_of(
        done, [&](const LoopSegment& one) { return have_common(one, segment); });
    if (is_new && redraw(segment, draws, x)) done.push_back(segment);
  }
  return done;
}

bool LoopMoves::redraw(const LoopSegment& segment, RandomSequence& draws, std::span<Vec3> x) const {
  const auto loop = std::span(residues_).subspan(segment.first, segment.last - segment.first);
  const std::vector<Vec3> from(x.begin(), x.end());
  for (int k = 0; k < most_draws; ++k)
    if (draw_loop(loop, start_, from, draws, x) && fits(loop, x)) return true;
  std::ranges::copy(from, x.begin());
  return false;
}

/// Whether the backbone of a loop overlaps with no other, and not with itself.
bool LoopMoves::fits(std::span<const LoopResidue> loop, std::span<const Vec3> x) const {
  if (!rules_) return true;
  const double farthest = rules_->largest() * rules_->largest();
  for (const LoopResidue& one : loop)
    for (const auto& part : one.parts)
      for (const Joint a : part) {
        if (!is_backbone_[a]) continue;
        for (const Joint b : backbone_) {
          const double apart = norm_squared(x[a] - x[b]);
          if (a == b || apart >= farthest) continue;
          const double least = rules_->of(std::min(a, b), std::max(a, b)) - most_overlap;
          if (least > 0.0 && apart < least * least) return false;
        }
      }
  return true;
}

}  // namespace pliant
