// SPDX-License-Identifier: MIT
#include "pliant/sample/pocket/pocket_turns.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "pliant/base/math/normal.hpp"

namespace pliant {
namespace {

// Of all frames so many turn domains, and so many segments; the others go along the modes alone.
constexpr double share_domains = 0.2, share_segments = 0.5;
constexpr std::size_t shortest = 6, longest = 30;  // nodes of a segment
constexpr std::size_t most_segments = 3;
constexpr double largest_angle = 60.0 / 180.0 * std::numbers::pi;
constexpr double line_noise = 0.15;  // of the axis through the ends of a segment, of length 1
constexpr int draws_in_vain = 12;

}  // namespace

PocketTurns::PocketTurns(const NetworkNodes& nodes, const NetworkModes& modes,
                         const std::vector<bool>& in_place)
    : nodes_(nodes), domains_(nodes, modes), limits_(nodes) {
  for (std::size_t k = 0; k < in_place.size(); ++k)
    if (in_place[k] && (is_in_chain(k + 1, k) || (k > 0 && is_in_chain(k - 1, k))))
      place_.push_back(k);
}

bool PocketTurns::is_in_chain(std::size_t node, std::size_t of) const {
  return node < nodes_.chain.size() && nodes_.chain[node] == nodes_.chain[of];
}

DrawnTurns PocketTurns::draw(RandomSequence& draws, double scale) const {
  const double kind = draws.uniform();
  if (kind < share_domains) return draw_domains(draws, scale);
  return kind < share_domains + share_segments ? draw_segments(draws, scale) : DrawnTurns{};
}

/// Whether nodes of the place are in pieces that turn against each other.
bool PocketTurns::parts_place(const DrawnTurns& drawn) const {
  const PieceTree& tree = *drawn.tree;
  std::vector<std::size_t> group(tree.piece_count(), 0);  // pieces that move together
  for (std::size_t p = 1; p < group.size(); ++p) {
    const bool turns =
        std::ranges::any_of(drawn.turns, [&](const PieceTurn& turn) { return turn.piece == p; });
    group[p] = turns ? p : group[static_cast<std::size_t>(tree.parent[p])];
  }
  return std::ranges::any_of(place_, [&](std::size_t node) {
    return group[tree.of_node[node]] != group[tree.of_node[place_.front()]];
  });
}

DrawnTurns PocketTurns::draw_domains(RandomSequence& draws, double scale) const {
  for (int k = 0; k < draws_in_vain && !domains_.empty(); ++k) {
    DrawnTurns drawn = domains_.draw(draws);
    if (drawn.tree == nullptr || !parts_place(drawn)) continue;
    const double share = scale * draws.uniform();
    for (PieceTurn& turn : drawn.turns) turn.angle *= share;
    return drawn;
  }
  return draw_segments(draws, scale);
}

/// Of a random length, about a random node of the place.
std::optional<PocketTurns::Segment> PocketTurns::draw_segment(RandomSequence& draws) const {
  if (place_.empty()) return std::nullopt;
  const std::size_t node = place_[draws.below(place_.size())];
  const std::size_t length = shortest + draws.below(longest - shortest + 1);
  const std::size_t before = draws.below(length);
  Segment found{node, node + 1};
  while (found.first > 0 && node - found.first < before && is_in_chain(found.first - 1, node))
    --found.first;
  while (found.last - found.first < length && is_in_chain(found.last, node)) ++found.last;
  // A chain as a whole is no segment.
  const bool is_linked =
      is_in_chain(found.last, node) || (found.first > 0 && is_in_chain(found.first - 1, node));
  if (found.last - found.first < shortest || !is_linked) return std::nullopt;
  return found;
}

/// About the line through the ends; where one end is free, about any through the other.
PieceTurn PocketTurns::turn_of(const Segment& segment, double scale, RandomSequence& draws) const {
  std::vector<Vec3> ends;
  const auto add_end = [&](std::size_t inside, std::size_t outside) {
    if (is_in_chain(outside, inside))
      ends.push_back(0.5 * (nodes_.positions[inside] + nodes_.positions[outside]));
  };
  if (segment.first > 0) add_end(segment.first, segment.first - 1);
  add_end(segment.last - 1, segment.last);
  PieceTurn turn;
  turn.pivot = 0.5 * (ends.front() + ends.back());
  turn.angle = scale * largest_angle * draws.uniform();
  const Vec3 line = ends.back() - ends.front();
  const double length = norm(line);
  const Vec3 axis =
      length > 1e-9 ? (1.0 / length) * line + line_noise * normal_vector(draws) : draws.direction();
  turn.axis = ((draws.uniform() < 0.5 ? -1.0 : 1.0) / norm(axis)) * axis;
  return turn;
}

bool PocketTurns::add_turn(const Segment& segment, double scale, RandomSequence& draws,
                           DrawnTurns& out) const {
  PieceTree tree = *out.tree;
  const auto piece = static_cast<std::uint32_t>(tree.piece_count());
  const auto link = [&](std::size_t before) {
    if (is_in_chain(before + 1, before))
      tree.links.push_back(
          {static_cast<std::uint32_t>(before), static_cast<std::uint32_t>(before + 1)});
  };
  for (std::size_t k = segment.first; k < segment.last; ++k) {
    if (tree.of_node[k] != 0) return false;
    tree.of_node[k] = piece;
  }
  if (segment.first > 0) link(segment.first - 1);
  link(segment.last - 1);
  tree.parent.push_back(0);
  PieceTurn turn = turn_of(segment, scale, draws);
  turn.piece = piece;
  std::vector<PieceTurn> turns = out.turns;
  turns.push_back(turn);
  if (!limits_.allow(moved_nodes(nodes_, tree, turns))) return false;
  out = {std::make_shared<const PieceTree>(std::move(tree)), std::move(turns)};
  return true;
}

DrawnTurns PocketTurns::draw_segments(RandomSequence& draws, double scale) const {
  PieceTree all{std::vector<std::uint32_t>(nodes_.positions.size(), 0), {-1}, {}};
  DrawnTurns out{std::make_shared<const PieceTree>(std::move(all)), {}};
  const std::size_t wanted = 1 + draws.below(most_segments);
  for (int k = 0; k < draws_in_vain && out.turns.size() < wanted; ++k)
    if (const auto segment = draw_segment(draws)) add_turn(*segment, scale, draws, out);
  return out.turns.empty() ? DrawnTurns{} : out;
}

}  // namespace pliant
