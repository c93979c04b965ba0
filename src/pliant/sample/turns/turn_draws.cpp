// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/turn_draws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <sstream>
#include <utility>

#include "pliant/base/math/cell_list.hpp"
#include "pliant/base/math/normal.hpp"

namespace pliant {
namespace {

// Angstrom, between alpha carbons
constexpr double pivot_noise = 1.5;
constexpr double widest_gap = 6.0;    // of a link: what turns spread over its torsions can close
constexpr double near_distance = 4.0;  // of nodes that no contact holds
/// So many pairs, and as many for a hundred nodes, may come too near: they are pushed apart.
constexpr double most_new_pairs = 2.0, most_new_pairs_a_node = 0.01;

constexpr double contact_distance = 8.0;

constexpr double largest_angle = 150.0 / 180.0 * std::numbers::pi;
constexpr double share_along_line = 0.5;  // of turns about the line through the links
constexpr double line_noise = 0.25;
constexpr int most_draws = 24;
constexpr int most_hinges = 5;
constexpr int most_halvings = 6;  // of angles, where no draw is possible

Vec3 normal_vector(RandomSequence& draws) {
  std::array<double, 3> x{};
  fill_normal(draws, x);
  return {x[0], x[1], x[2]};
}

Vec3 unit(Vec3 x) {
  const double length = norm(x);
  return length > 1e-9 ? (1.0 / length) * x : Vec3{0, 0, 1};
}

/// The direction in which points are spread furthest.
Vec3 line_through(std::span<const Vec3> points, Vec3 centre) {
  if (points.size() < 2) return {};
  std::array<double, 9> a{}, vectors{};
  for (const Vec3 point : points) {
    const Vec3 r = point - centre;
    const std::array<double, 3> x{r.x, r.y, r.z};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) a[3 * i + j] += x[i] * x[j];
  }
  find_eigenvectors(a, vectors, 3);
  std::size_t most = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (a[4 * k] > a[4 * most]) most = k;
  return {vectors[most], vectors[3 + most], vectors[6 + most]};
}

/// A rigid motion to first order.
struct Screw {
  Vec3 turn, shift;  ///< x moves by turn x x + shift
};

/// Of the nodes that `is_in` chooses, by least squares of their displacements.
template <class IsIn>
Screw screw_of(std::span<const Vec3> nodes, std::span<const Vec3> moves, const IsIn& is_in) {
  Vec3 centre, shift, torque;
  double count = 0.0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (is_in(i)) {
      centre += nodes[i];
      shift += moves[i];
      count += 1.0;
    }
  centre *= 1.0 / count;
  shift *= 1.0 / count;
  std::array<double, 9> inertia{}, vectors{};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!is_in(i)) continue;
    const Vec3 r = nodes[i] - centre;
    torque += cross(r, moves[i] - shift);
    const std::array<double, 3> x{r.x, r.y, r.z};
    for (std::size_t a = 0; a < 3; ++a) {
      inertia[4 * a] += norm_squared(r);
      for (std::size_t b = 0; b < 3; ++b) inertia[3 * a + b] -= x[a] * x[b];
    }
  }
  find_eigenvectors(inertia, vectors, 3);
  Screw screw;
  const double least = 1e-6 * (inertia[0] + inertia[4] + inertia[8]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 axis{vectors[k], vectors[3 + k], vectors[6 + k]};
    if (inertia[4 * k] > least) screw.turn += (dot(axis, torque) / inertia[4 * k]) * axis;
  }
  screw.shift = shift - cross(screw.turn, centre);
  return screw;
}

std::vector<Vec3> node_moves(const NetworkModes& modes, std::size_t mode) {
  const auto u = modes.directions.row(mode);
  std::vector<Vec3> moves(u.size() / 3);
  for (std::size_t i = 0; i < moves.size(); ++i) moves[i] = {u[3 * i], u[3 * i + 1], u[3 * i + 2]};
  return moves;
}

/// Whether each node moves with that piece.
std::vector<std::uint8_t> moved_with(const PieceTree& tree, std::uint32_t piece) {
  std::vector<std::uint8_t> pieces(tree.piece_count(), 0), nodes;
  pieces[piece] = 1;
  for (std::uint32_t p = piece + 1; p < pieces.size(); ++p)
    if (tree.parent[p] >= 0) pieces[p] = pieces[static_cast<std::size_t>(tree.parent[p])];
  for (const std::uint32_t p : tree.of_node) nodes.push_back(pieces[p]);
  return nodes;
}

}  // namespace

/// One of the ways in which turns are drawn.
struct TurnDraws::Way {
  double share;
  int pieces;    ///< that turn; 0: all, as a draw of the modes has it
  int best_of;   ///< so many draws
  double closing, soft;  ///< weights of contacts made, and of the softness of the axis
};

namespace {
constexpr std::size_t way_count = 6;
}

TurnDraws::TurnDraws(const NetworkNodes& nodes, const NetworkModes& modes)
    : nodes_(nodes), modes_(modes), trees_(find_pieces(nodes, modes)) {
  for (std::size_t tree = 0; tree < trees_.size(); ++tree) {
    first_of_tree_.push_back(hinges_.size());
    for (std::uint32_t piece = 1; piece < trees_[tree].piece_count(); ++piece)
      hinges_.push_back(hinge_of(tree, piece, modes));
  }
  first_of_tree_.push_back(hinges_.size());
  near_at_start_ = pairs_within(near_distance, nodes.positions);
}

TurnDraws::Hinge TurnDraws::hinge_of(std::size_t tree, std::uint32_t piece,
                                     const NetworkModes& modes) const {
  Hinge hinge{.tree = tree, .piece = piece, .middles = {}, .centre = {}, .line = {}, .soft = {}};
  const std::vector<std::uint8_t> with = moved_with(trees_[tree], piece);
  const double n = double(with.size());
  const double size = double(std::count(with.begin(), with.end(), 1));
  hinge.weight = (std::min(size, n - size) / n) * (std::min(size, n - size) / n);
  for (const ChainLink link : trees_[tree].links)
    if (with[link.before] != with[link.after])
      hinge.middles.push_back(0.5 *
                              (nodes_.positions[link.before] + nodes_.positions[link.after]));
  const std::span<const Vec3> points = hinge.middles.empty() ? nodes_.positions : hinge.middles;
  for (const Vec3 point : points) hinge.centre += (1.0 / double(points.size())) * point;
  hinge.line = line_through(hinge.middles, hinge.centre);
  double trace = 0.0;
  for (std::size_t k = 0; k < modes.variances.size(); ++k) {
    const std::vector<Vec3> moves = node_moves(modes, k);
    const auto turn_of_side = [&](std::uint8_t side) {
      return screw_of(nodes_.positions, moves, [&](std::size_t i) { return with[i] == side; }).turn;
    };
    const Vec3 turn = turn_of_side(1) - turn_of_side(0);
    const std::array<double, 3> w{turn.x, turn.y, turn.z};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        hinge.soft[3 * a + b] += modes.variances[k] * w[a] * w[b];
    trace += modes.variances[k] * norm_squared(turn);
  }
  if (trace > 0.0)
    for (double& value : hinge.soft) value *= 1.0 / trace;
  return hinge;
}

std::span<const TurnDraws::Hinge> TurnDraws::of_tree(std::size_t tree) const {
  return std::span(hinges_).subspan(first_of_tree_[tree],
                                    first_of_tree_[tree + 1] - first_of_tree_[tree]);
}

const TurnDraws::Hinge& TurnDraws::choose(std::span<const Hinge> among,
                                          RandomSequence& draws) const {
  double all = 0.0;
  for (const Hinge& hinge : among) all += hinge.weight;
  double left = draws.uniform() * all;
  for (const Hinge& hinge : among.first(among.size() - 1)) {
    left -= hinge.weight;
    if (left < 0.0) return hinge;
  }
  return among.back();
}

PieceTurn TurnDraws::turn_of(const Hinge& hinge, RandomSequence& draws) {
  PieceTurn turn{.piece = hinge.piece, .axis = draws.direction(), .pivot = hinge.centre,
                 .angle = largest_angle * draws.uniform()};
  if (norm_squared(hinge.line) > 0.0 && draws.uniform() < share_along_line) {
    turn.axis = unit(hinge.line + line_noise * normal_vector(draws));
    if (draws.uniform() < 0.5) turn.axis = -turn.axis;
  }
  turn.pivot += pivot_noise * normal_vector(draws);
  return turn;
}

/// All pieces of a tree turn as they do in a draw of the modes, the most of them by an angle drawn.
DrawnTurns TurnDraws::draw_along_modes(double scale, RandomSequence& draws) const {
  for (int k = 0; k < most_draws; ++k) {
    DrawnTurns drawn = turns_in_modes(scale, draws);
    if (!drawn.turns.empty() && is_possible(moved(drawn))) return drawn;
  }
  return {};
}

DrawnTurns TurnDraws::turns_in_modes(double scale, RandomSequence& draws) const {
  const std::size_t at = draws.below(trees_.size());
  const PieceTree& tree = trees_[at];
  std::vector<double> amplitudes(modes_.variances.size());
  fill_normal(draws, amplitudes);
  std::vector<Vec3> moves(nodes_.positions.size());
  for (std::size_t k = 0; k < amplitudes.size(); ++k) {
    const double scale = amplitudes[k] * std::sqrt(modes_.variances[k]);
    const auto u = modes_.directions.row(k);
    for (std::size_t i = 0; i < moves.size(); ++i)
      moves[i] += scale * Vec3{u[3 * i], u[3 * i + 1], u[3 * i + 2]};
  }
  std::vector<Screw> screws;
  for (std::uint32_t p = 0; p < tree.piece_count(); ++p)
    screws.push_back(screw_of(nodes_.positions, moves,
                              [&](std::size_t i) { return tree.of_node[i] == p; }));
  DrawnTurns drawn{&tree, {}};
  double most = 0.0;
  for (const Hinge& hinge : of_tree(at)) {
    const Screw& own = screws[hinge.piece];
    const Screw& parent = screws[static_cast<std::size_t>(tree.parent[hinge.piece])];
    const Vec3 turn = own.turn - parent.turn, shift = own.shift - parent.shift;
    const double length = norm(turn);
    if (!(length > 1e-9)) continue;
    // The axis is where the screw does not move points across it.
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

DrawnTurns TurnDraws::draw(RandomSequence& draws) const {
  if (empty()) return {};
  static const std::array<Way, way_count> ways = [] {
    std::array<Way, way_count> out{
        Way{0.20, 1, 1, 0.0, 0.0}, Way{0.15, 1, 4, 0.0, -1.0}, Way{0.25, 1, 8, 1.0, 1.0},
        Way{0.20, 2, 6, 1.0, 1.0}, Way{0.10, 2, 3, 0.0, -1.0}, Way{0.10, 0, 1, 0.0, 0.0}};
    if (const char* text = std::getenv("PLIANT_TURNS")) {
      std::istringstream in(text);
      for (Way& way : out) in >> way.share;
    }
    return out;
  }();
  double left = draws.uniform();
  std::size_t at = 0;
  while (at + 1 < ways.size() && (left -= ways[at].share) >= 0.0) ++at;
  // Small turns are possible always.
  double scale = 1.0;
  for (int k = 0; k < most_halvings; ++k, scale *= 0.5) {
    DrawnTurns drawn =
        ways[at].pieces == 0 ? draw_along_modes(scale, draws) : draw_turns(ways[at], scale, draws);
    if (drawn.tree != nullptr) return drawn;
  }
  return {};
}

/// One piece after the other.
DrawnTurns TurnDraws::draw_turns(const Way& way, double scale, RandomSequence& draws) const {
  for (int k = 0; k < most_hinges; ++k) {
    const Hinge& first = choose(hinges_, draws);
    DrawnTurns drawn{&trees_[first.tree], {}};
    if (!add_best(way, first, scale, draws, drawn)) continue;
    if (way.pieces == 1) return drawn;
    const Hinge& second = choose(of_tree(first.tree), draws);
    if (second.piece != first.piece) add_best(way, second, scale, draws, drawn);
    return drawn;
  }
  return {};
}

/// Adds the best of several turns that are possible, by the ranks of what is asked of it. False if
/// none is.
bool TurnDraws::add_best(const Way& way, const Hinge& hinge, double scale, RandomSequence& draws,
                         DrawnTurns& drawn) const {
  std::vector<ScoredTurn> found;
  for (int k = 0; k < most_draws && std::ssize(found) < way.best_of; ++k) {
    PieceTurn turn = turn_of(hinge, draws);
    turn.angle *= scale;
    drawn.turns.push_back(turn);
    const std::vector<Vec3> at = moved(drawn);
    drawn.turns.pop_back();
    if (!is_possible(at)) continue;
    const double contacts =
        way.closing != 0.0 ? double(pairs_within(contact_distance, at)) : 0.0;
    found.push_back({turn, contacts, softness(hinge, turn.axis)});
  }
  if (found.empty()) return false;
  const auto score = [&](const ScoredTurn& one) {
    double sum = 0.0;
    for (const ScoredTurn& other : found)
      sum += (one.contacts > other.contacts ? way.closing : 0.0) +
             (one.softness > other.softness ? way.soft : 0.0);
    return sum;
  };
  const auto best = std::max_element(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return score(a) < score(b);
  });
  drawn.turns.push_back(best->turn);
  return true;
}

double TurnDraws::softness(const Hinge& hinge, Vec3 axis) {
  const std::array<double, 3> a{axis.x, axis.y, axis.z};
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) sum += a[i] * hinge.soft[3 * i + j] * a[j];
  return sum;
}

std::vector<Vec3> TurnDraws::moved(const DrawnTurns& drawn) const {
  TurnCourse course(nodes_, *drawn.tree);
  const auto motions = course.motions(drawn.turns, 1.0);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < motions.size(); ++i)
    out.push_back(motions[i](nodes_.positions[i]));
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
  CellList(nodes, length * nodes_.scale).for_each_pair([&](std::uint32_t i, std::uint32_t j, double) {
    count += nodes_.chain[i] != nodes_.chain[j] || j - i > 2 ? 1 : 0;
  });
  return count;
}

}  // namespace pliant
