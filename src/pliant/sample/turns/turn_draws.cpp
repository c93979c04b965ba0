// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/turn_draws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "pliant/base/math/cell_list.hpp"
#include "pliant/base/math/normal.hpp"
#include "pliant/sample/turns/screw.hpp"

namespace pliant {
namespace {

// A domain that is open closes about a soft axis until both sides touch; one that is closed opens
// about an axis that its contacts make stiff. Shares and weights were chosen on 12 proteins
// (../README.md).
constexpr TurnWay ways[] = {
    {.share = 0.20, .pieces = 1, .best_of = 1, .closing = 0.0, .soft = 0.0},
    {.share = 0.15, .pieces = 1, .best_of = 4, .closing = 0.0, .soft = -1.0},
    {.share = 0.25, .pieces = 1, .best_of = 8, .closing = 1.0, .soft = 1.0},
    {.share = 0.20, .pieces = 2, .best_of = 6, .closing = 1.0, .soft = 1.0},
    {.share = 0.10, .pieces = 2, .best_of = 3, .closing = 0.0, .soft = -1.0},
    {.share = 0.10, .pieces = 0, .best_of = 1, .closing = 0.0, .soft = 0.0},
};

// Angstrom, between alpha carbons
constexpr double pivot_noise = 1.5;
constexpr double widest_gap = 6.0;        // of a link: the torsions beside it can close that
constexpr double near_distance = 4.0;     // of nodes that are no neighbours
constexpr double contact_distance = 8.0;  // that counts as a contact
/// So many pairs, and as many for a hundred nodes, may come too near: they are pushed apart.
constexpr double most_new_pairs = 2.0, most_new_pairs_a_node = 0.01;

constexpr double largest_angle = 150.0 / 180.0 * std::numbers::pi;
constexpr double share_along_line = 0.5;  // of turns about the line through the links
constexpr double line_noise = 0.25;
constexpr int most_draws = 24, most_hinges = 5;  // in vain
constexpr int most_halvings = 6;                 // of angles

struct ScoredTurn {
  PieceTurn turn;
  double contacts, softness;
};

Vec3 normal_vector(RandomSequence& draws) {
  std::array<double, 3> x{};
  fill_normal(draws, x);
  return {x[0], x[1], x[2]};
}

Vec3 unit(Vec3 x) {
  const double length = norm(x);
  return length > 1e-9 ? (1.0 / length) * x : Vec3{0, 0, 1};
}

/// An index, by weight(index).
template <class Weight>
std::size_t choose(std::size_t count, const Weight& weight, RandomSequence& draws) {
  double all = 0.0;
  for (std::size_t k = 0; k < count; ++k) all += weight(k);
  double left = draws.uniform() * all;
  std::size_t at = 0;
  while (at + 1 < count && (left -= weight(at)) >= 0.0) ++at;
  return at;
}

const Hinge& choose_hinge(std::span<const Hinge> hinges, RandomSequence& draws) {
  return hinges[choose(
      hinges.size(), [&](std::size_t k) { return hinges[k].weight; }, draws)];
}

PieceTurn turn_of(const Hinge& hinge, double scale, RandomSequence& draws) {
  PieceTurn turn{.piece = hinge.piece,
                 .axis = draws.direction(),
                 .pivot = hinge.centre,
                 .angle = scale * largest_angle * draws.uniform()};
  if (norm_squared(hinge.line) > 0.0 && draws.uniform() < share_along_line) {
    turn.axis = unit(hinge.line + line_noise * normal_vector(draws));
    if (draws.uniform() < 0.5) turn.axis = -turn.axis;
  }
  turn.pivot += pivot_noise * normal_vector(draws);
  return turn;
}

/// Over how many others a turn wins, weighted.
double score(const ScoredTurn& one, std::span<const ScoredTurn> all, const TurnWay& way) {
  double sum = 0.0;
  for (const ScoredTurn& other : all)
    sum += (one.contacts > other.contacts ? way.closing : 0.0) +
           (one.softness > other.softness ? way.soft : 0.0);
  return sum;
}

const PieceTurn& best_of(std::span<const ScoredTurn> all, const TurnWay& way) {
  return std::max_element(all.begin(), all.end(),
                          [&](const ScoredTurn& a, const ScoredTurn& b) {
                            return score(a, all, way) < score(b, all, way);
                          })
      ->turn;
}

}  // namespace

TurnDraws::TurnDraws(const NetworkNodes& nodes, NetworkModes modes)
    : nodes_(nodes), modes_(std::move(modes)) {
  for (PieceTree& tree : find_pieces(nodes, modes_)) {
    std::vector<Hinge> hinges = hinges_of(nodes, tree, modes_);
    trees_.push_back({std::move(tree), std::move(hinges)});
  }
  near_at_start_ = pairs_within(near_distance, nodes.positions);
}

DrawnTurns TurnDraws::draw(RandomSequence& draws) const {
  if (empty()) return {};
  const TurnWay& way = ways[choose(
      std::size(ways), [](std::size_t k) { return ways[k].share; }, draws)];
  double scale = 1.0;  // turns that are small enough are always possible
  for (int k = 0; k < most_halvings; ++k, scale *= 0.5) {
    DrawnTurns drawn =
        way.pieces == 0 ? draw_along_modes(scale, draws) : draw_turns(way, scale, draws);
    if (drawn.tree != nullptr) return drawn;
  }
  return {};
}

/// A tree, by the weights of its hinges.
const TurnDraws::Tree& TurnDraws::choose_tree(RandomSequence& draws) const {
  const auto weight = [&](std::size_t k) {
    double sum = 0.0;
    for (const Hinge& hinge : trees_[k].hinges) sum += hinge.weight;
    return sum;
  };
  return trees_[choose(trees_.size(), weight, draws)];
}

/// One piece after the other.
DrawnTurns TurnDraws::draw_turns(const TurnWay& way, double scale, RandomSequence& draws) const {
  for (int k = 0; k < most_hinges; ++k) {
    const Tree& tree = choose_tree(draws);
    DrawnTurns drawn{&tree.pieces, {}};
    const Hinge& first = choose_hinge(tree.hinges, draws);
    if (!add_best(way, first, scale, draws, drawn)) continue;
    if (way.pieces == 1) return drawn;
    const Hinge& second = choose_hinge(tree.hinges, draws);
    if (second.piece != first.piece) add_best(way, second, scale, draws, drawn);
    return drawn;
  }
  return {};
}

/// Adds the best of several turns that are possible. False if none is.
bool TurnDraws::add_best(const TurnWay& way, const Hinge& hinge, double scale,
                         RandomSequence& draws, DrawnTurns& drawn) const {
  std::vector<ScoredTurn> found;
  for (int k = 0; k < most_draws && std::ssize(found) < way.best_of; ++k) {
    const PieceTurn turn = turn_of(hinge, scale, draws);
    drawn.turns.push_back(turn);
    const std::vector<Vec3> at = moved(drawn);
    drawn.turns.pop_back();
    if (!is_possible(at)) continue;
    const double contacts = way.closing != 0.0 ? double(pairs_within(contact_distance, at)) : 0.0;
    found.push_back({turn, contacts, softness(hinge, turn.axis)});
  }
  if (found.empty()) return false;
  drawn.turns.push_back(best_of(found, way));
  return true;
}

DrawnTurns TurnDraws::draw_along_modes(double scale, RandomSequence& draws) const {
  for (int k = 0; k < most_draws; ++k) {
    DrawnTurns drawn = turns_in_modes(scale, draws);
    if (!drawn.turns.empty() && is_possible(moved(drawn))) return drawn;
  }
  return {};
}

/// All pieces turn against each other as they do in a draw of the modes, the most of them by an
/// angle drawn.
DrawnTurns TurnDraws::turns_in_modes(double scale, RandomSequence& draws) const {
  const Tree& tree = trees_[draws.below(trees_.size())];
  std::vector<double> amplitudes(modes_.variances.size());
  fill_normal(draws, amplitudes);
  const std::vector<Vec3> moves = moves_along(modes_, amplitudes);
  std::vector<Screw> screws;
  for (std::uint32_t p = 0; p < tree.pieces.piece_count(); ++p)
    screws.push_back(screw_of(nodes_.positions, moves, tree.pieces.of_node, p));
  DrawnTurns drawn{&tree.pieces, {}};
  double most = 0.0;
  for (const Hinge& hinge : tree.hinges) {
    const Screw& own = screws[hinge.piece];
    const Screw& parent = screws[static_cast<std::size_t>(tree.pieces.parent[hinge.piece])];
    const Vec3 turn = own.turn - parent.turn, shift = own.shift - parent.shift;
    const double length = norm(turn);
    if (!(length > 1e-9)) continue;
    // Points of the axis move along it alone.
    Vec3 pivot = (1.0 / (length * length)) * cross(turn, shift);
    if (!hinge.middles.empty() && draws.uniform() < 0.5)
      pivot = hinge.centre + pivot_noise * normal_vector(draws);
    drawn.turns.push_back({hinge.piece, (1.0 / length) * turn, pivot, length});
    most = std::max(most, length);
  }
  const double factor = scale * largest_angle * draws.uniform() / std::max(most, 1e-9);
  for (PieceTurn& turn : drawn.turns) turn.angle *= factor;
  return drawn;
}

std::vector<Vec3> TurnDraws::moved(const DrawnTurns& drawn) const {
  TurnCourse course(nodes_, *drawn.tree);
  const auto motions = course.motions(drawn.turns, 1.0);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < motions.size(); ++i) out.push_back(motions[i](nodes_.positions[i]));
  return out;
}

bool TurnDraws::is_possible(std::span<const Vec3> moved) const {
  for (std::size_t i = 0; i + 1 < moved.size(); ++i) {
    if (nodes_.chain[i] != nodes_.chain[i + 1]) continue;
    const double before = distance(nodes_.positions[i], nodes_.positions[i + 1]);
    if (std::abs(distance(moved[i], moved[i + 1]) - before) > widest_gap) return false;
  }
  const double most = most_new_pairs + most_new_pairs_a_node * double(moved.size());
  return double(pairs_within(near_distance, moved)) <= double(near_at_start_) + most;
}

/// Pairs of nodes that are no neighbours along a chain.
std::size_t TurnDraws::pairs_within(double length, std::span<const Vec3> nodes) const {
  std::size_t count = 0;
  CellList(nodes, length * nodes_.scale)
      .for_each_pair([&](std::uint32_t i, std::uint32_t j, double) {
        count += nodes_.chain[i] != nodes_.chain[j] || j - i > 2 ? 1 : 0;
      });
  return count;
}

}  // namespace pliant
