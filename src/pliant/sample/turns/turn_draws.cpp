// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/turn_draws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "pliant/base/math/elementary.hpp"
#include "pliant/base/math/normal.hpp"
#include "pliant/sample/turns/screw.hpp"

namespace pliant {
namespace {

// Axes by their softness in the modes to a power; 0: at random, or near the line through the links.
struct Axes {
  double share, power;
};
constexpr Axes axes[] = {{0.4, 0.0}, {0.5, 2.0}, {0.1, -1.0}};

// So many draws turn all pieces as a draw of the modes does; more of open molecules, whose modes
// show the way: so much more for an openness of 1, less for -1.
constexpr double share_in_modes = 0.45, more_if_open = 0.35;

// How many pieces turn in the others.
struct Pieces {
  double share;
  std::size_t count;
};
constexpr Pieces turning[] = {{0.3, 1}, {0.7, 2}};

// Of open molecules, by their openness: pieces turn about an axis where it lies in the modes.
constexpr double share_of_pivots = 0.6;

// Angstrom, between alpha carbons
constexpr double pivot_noise = 1.5;

constexpr double largest_angle = 150.0 / 180.0 * std::numbers::pi;
constexpr double share_along_line = 0.5;  // of turns about the line through the links
constexpr double line_noise = 0.25;
constexpr int candidates = 96;    // of which one is taken
constexpr int most_halvings = 6;  // of angles, after candidates that are all impossible

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

/// One row of a table, by the rows' shares.
template <class Row, std::size_t rows>
const Row& one_of(const Row (&table)[rows], RandomSequence& draws) {
  return table[choose(
      rows, [&](std::size_t k) { return table[k].share; }, draws)];
}

/// The root of softness to the power of `power`, of 2 or -1.
double weight_of(double softness, double power) {
  constexpr double least = 0.01;
  const double x = std::max(softness, least);
  return power < 0.0 ? 1.0 / std::sqrt(x) : x;
}

Vec3 random_axis(const Hinge& hinge, RandomSequence& draws) {
  const bool along = norm_squared(hinge.line) > 0.0 && draws.uniform() < share_along_line;
  if (!along) return draws.direction();
  const Vec3 axis = unit(hinge.line + line_noise * normal_vector(draws));
  return draws.uniform() < 0.5 ? -axis : axis;
}

/// Normal numbers along the main axes, whose variances are powers of their softness.
Vec3 axis_of(const Hinge& hinge, RandomSequence& draws) {
  const double power = one_of(axes, draws).power;
  if (power == 0.0) return random_axis(hinge, draws);
  const Vec3 x = normal_vector(draws);
  const std::array<double, 3> along{x.x, x.y, x.z};
  Vec3 axis;
  for (std::size_t k = 0; k < 3; ++k)
    axis += weight_of(hinge.softness[k], power) * along[k] * hinge.axes[k];
  return unit(axis);
}

/// A point of the axis about which the piece turns in the modes, of those along `axis`.
Vec3 pivot_in_modes(const Hinge& hinge, Vec3 axis) {
  Vec3 shift;
  for (std::size_t k = 0; k < 3; ++k) shift += dot(axis, hinge.axes[k]) * hinge.shifts[k];
  return cross(axis, shift);
}

PieceTurn turn_of(const Hinge& hinge, double scale, double openness, RandomSequence& draws) {
  PieceTurn turn{.piece = hinge.piece,
                 .axis = axis_of(hinge, draws),
                 .pivot = hinge.centre,
                 .angle = scale * largest_angle * draws.uniform()};
  if (draws.uniform() < share_of_pivots * openness) turn.pivot = pivot_in_modes(hinge, turn.axis);
  turn.pivot += pivot_noise * normal_vector(draws);
  return turn;
}

/// A number of Gumbel's distribution: of candidates with such a number on top of the logarithms of
/// their weights, the highest is as frequent as its weight says.
double gumbel(RandomSequence& draws) {
  constexpr double least = 1e-300;
  return -exact_bits_log(-exact_bits_log(std::max(draws.uniform(), least)));
}

}  // namespace

TurnDraws::TurnDraws(const NetworkNodes& nodes, NetworkModes modes)
    : nodes_(nodes),
      modes_(std::move(modes)),
      limits_(nodes),
      plausible_(nodes.positions, nodes.scale) {
  for (PieceTree& tree : find_pieces(nodes, modes_)) {
    std::vector<Hinge> hinges = hinges_of(nodes, tree, modes_);
    trees_.push_back({std::make_shared<PieceTree>(std::move(tree)), std::move(hinges)});
  }
}

DrawnTurns TurnDraws::draw(RandomSequence& draws) const {
  if (empty()) return {};
  double scale = 1.0;  // turns that are small enough are always possible
  for (int k = 0; k < most_halvings; ++k, scale *= 0.5) {
    std::vector<Candidate> drawn;
    for (int c = 0; c < candidates; ++c) drawn.push_back(draw_candidate(scale, draws));
    std::stable_sort(drawn.begin(), drawn.end(), [](const Candidate& one, const Candidate& other) {
      return one.rank > other.rank;
    });
    for (Candidate& one : drawn)
      if (!one.turns.turns.empty() && limits_.allow(moved(one.turns))) return std::move(one.turns);
  }
  return {};
}

TurnDraws::Candidate TurnDraws::draw_candidate(double scale, RandomSequence& draws) const {
  const double in_modes = share_in_modes + more_if_open * plausible_.openness();
  Candidate one{draws.uniform() < in_modes
                    ? turns_in_modes(scale, draws)
                    : draw_turns(one_of(turning, draws).count, scale, draws)};
  one.rank = plausible_.score(moved(one.turns)) + gumbel(draws);
  return one;
}

/// A tree with so many pieces that turn, where there is one, by the weights of its hinges.
const TurnDraws::Tree& TurnDraws::choose_tree(std::size_t pieces, RandomSequence& draws) const {
  const auto weight = [&](std::size_t k) {
    constexpr double too_few = 1e-9;
    double sum = 0.0;
    for (const Hinge& hinge : trees_[k].hinges) sum += hinge.weight;
    return trees_[k].hinges.size() < pieces ? too_few * sum : sum;
  };
  return trees_[choose(trees_.size(), weight, draws)];
}

/// The second piece turns less.
DrawnTurns TurnDraws::draw_turns(std::size_t pieces, double scale, RandomSequence& draws) const {
  const Tree& tree = choose_tree(pieces, draws);
  DrawnTurns drawn{tree.pieces, {}};
  std::vector<double> weights;
  for (const Hinge& hinge : tree.hinges) weights.push_back(hinge.weight);
  for (std::size_t turn = 0; turn < std::min(pieces, tree.hinges.size()); ++turn) {
    const std::size_t at = choose(
        weights.size(), [&](std::size_t h) { return weights[h]; }, draws);
    weights[at] = 0.0;
    const double share = turn == 0 ? 1.0 : draws.uniform();
    drawn.turns.push_back(turn_of(tree.hinges[at], scale * share, plausible_.openness(), draws));
  }
  return drawn;
}

/// All pieces turn against each other as they do in a draw of the modes, the most of them by an
/// angle drawn.
DrawnTurns TurnDraws::turns_in_modes(double scale, RandomSequence& draws) const {
  const Tree& tree = trees_[draws.below(trees_.size())];
  std::vector<double> amplitudes(modes_.variances.size());
  fill_normal(draws, amplitudes);
  const std::vector<Vec3> moves = moves_along(modes_, amplitudes);
  std::vector<Screw> screws;
  for (std::uint32_t p = 0; p < tree.pieces->piece_count(); ++p)
    screws.push_back(screw_of(nodes_.positions, moves, tree.pieces->of_node, p));
  DrawnTurns drawn{tree.pieces, {}};
  double most = 0.0;
  for (const Hinge& hinge : tree.hinges) {
    const Screw& own = screws[hinge.piece];
    const Screw& parent = screws[static_cast<std::size_t>(tree.pieces->parent[hinge.piece])];
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
  return moved_nodes(nodes_, *drawn.tree, drawn.turns);
}

}  // namespace pliant
