// SPDX-License-Identifier: MIT
#include "pliant/path/turn_ways.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pliant/base/math/axis_angle.hpp"
#include "pliant/base/math/elementary.hpp"
#include "pliant/base/math/superposition.hpp"
#include "pliant/path/path_walker.hpp"
#include "pliant/path/turn_guess.hpp"

namespace pliant {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
// The middle of the chord of a smaller turn is within 8 % of the radius of its arc.
constexpr double least_turn = 45.0 * degree;
// From here on the other way round is at most twice as far.
constexpr double least_two_way = 120.0 * degree;
constexpr double most_unexplained = 0.5;  // of the r.m.s. distance, by pieces that keep their shape
constexpr double between_goals = 1.0;     // Angstrom, r.m.s.

/// The residues with asked atoms, each at the middle of these.
struct AskedNodes {
  NetworkNodes start;
  std::vector<Vec3> end;                ///< (M) Angstrom
  std::vector<std::uint32_t> of_asked;  ///< (K)
};

/// Node by node, since the asked atoms of a residue follow each other.
AskedNodes nodes_of(const PathSide& side, std::span<const Vec3> goal) {
  AskedNodes nodes;
  std::vector<double> counts;
  const AtomTable& atoms = side.model.structure.atoms;
  for (std::size_t k = 0; k < side.asked.size(); ++k) {
    const std::uint32_t atom = side.asked[k], before = side.asked[k > 0 ? k - 1 : 0];
    if (k == 0 || side.leader[atom] != side.leader[before]) {
      const auto chain_of = [&](std::uint32_t a) -> const std::string& {
        return atoms.residues[atoms.residue_of[a]].chain;
      };
      const std::uint32_t chain = k == 0 ? 0 : nodes.start.chain.back();
      nodes.start.chain.push_back(chain_of(atom) == chain_of(before) ? chain : chain + 1);
      nodes.start.positions.emplace_back();
      nodes.end.emplace_back();
      counts.push_back(0.0);
    }
    nodes.start.positions.back() += side.model.positions[atom];
    nodes.end.back() += goal[k];
    counts.back() += 1.0;
    nodes.of_asked.push_back(static_cast<std::uint32_t>(counts.size() - 1));
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    nodes.start.positions[i] *= 1.0 / counts[i];
    nodes.end[i] *= 1.0 / counts[i];
  }
  return nodes;
}

/// (P) the motion that brings each piece to where it is at the end.
std::vector<RigidMotion> fits(const AskedNodes& nodes, const PieceTree& tree) {
  std::vector<std::vector<Vec3>> here(tree.piece_count()), there(tree.piece_count());
  for (std::size_t i = 0; i < nodes.end.size(); ++i) {
    here[tree.of_node[i]].push_back(nodes.start.positions[i]);
    there[tree.of_node[i]].push_back(nodes.end[i]);
  }
  std::vector<RigidMotion> motions;
  for (std::size_t p = 0; p < here.size(); ++p) motions.push_back(superposition(here[p], there[p]));
  return motions;
}

bool explain(std::span<const RigidMotion> fitted, const PieceTree& tree, const AskedNodes& nodes) {
  std::vector<Vec3> left;
  for (std::size_t i = 0; i < nodes.end.size(); ++i)
    left.push_back(nodes.end[i] - fitted[tree.of_node[i]](nodes.start.positions[i]));
  return rms(left) <= most_unexplained * rms(ways(nodes.start.positions, nodes.end));
}

/// The point nearest to `by` on the axis about which a motion turns while it shifts along it:
/// by + (s + cot(angle / 2) axis x s) / 2, where s is the shift of `by` across the axis.
Vec3 point_of_axis(const RigidMotion& motion, const AxisAngle& turn, Vec3 by) {
  const Vec3 shift = motion(by) - by;
  const Vec3 across = shift - dot(shift, turn.axis) * turn.axis;
  const double half = 0.5 * turn.angle;
  const double cotangent = exact_bits_cos(half) / exact_bits_cos(half - 0.5 * std::numbers::pi);
  return by + 0.5 * (across + cotangent * cross(turn.axis, across));
}

/// The middle of the links between a piece and its parent; of the start, if no chain joins them.
Vec3 middle_of_links(const NetworkNodes& nodes, const PieceTree& tree, std::uint32_t piece) {
  std::vector<Vec3> links;
  const auto parent = static_cast<std::uint32_t>(tree.parent[piece]);
  for (const auto [before, after] : tree.links) {
    const std::uint32_t one = tree.of_node[before], other = tree.of_node[after];
    if ((one == piece && other == parent) || (one == parent && other == piece))
      links.push_back(0.5 * (nodes.positions[before] + nodes.positions[after]));
  }
  const std::vector<Vec3>& of = links.empty() ? nodes.positions : links;
  Vec3 sum;
  for (const Vec3 x : of) sum += x;
  return (1.0 / double(of.size())) * sum;
}

/// The turns that bring each piece to where it is at the end, seen from its parent.
std::vector<PieceTurn> turns_of(const NetworkNodes& nodes, const PieceTree& tree,
                                std::span<const RigidMotion> fitted) {
  std::vector<PieceTurn> turns;
  for (std::uint32_t p = 1; p < tree.piece_count(); ++p) {
    const RigidMotion back = inverse(fitted[static_cast<std::size_t>(tree.parent[p])]);
    const RigidMotion relative{product(back.rotation, fitted[p].rotation), back(fitted[p].shift)};
    const AxisAngle turn = axis_angle(relative.rotation);
    if (turn.angle < degree) continue;  // its axis is far away
    const Vec3 pivot = point_of_axis(relative, turn, middle_of_links(nodes, tree, p));
    turns.push_back({.piece = p, .axis = turn.axis, .pivot = pivot, .angle = turn.angle});
  }
  return turns;
}

TurnWay way_of(TurnGuess& guess, const AskedNodes& nodes, const PathSide& side,
               std::span<const Vec3> goal) {
  TurnWay way;
  way.clashes = guess.clashes();
  const int count = std::max(1, static_cast<int>(std::ceil(guess.length() / between_goals)));
  for (int k = 1; k < count; ++k) {
    const std::vector<RigidMotion> motions = guess.motions(double(k) / count);
    std::vector<Vec3>& places = way.goals.emplace_back();
    for (std::size_t a = 0; a < side.asked.size(); ++a)
      places.push_back(motions[nodes.of_asked[a]](side.model.positions[side.asked[a]]));
  }
  way.goals.emplace_back(goal.begin(), goal.end());
  return way;
}

/// By the shorter way round first.
std::vector<TurnWay> ways_by(const PieceTree& tree, std::span<const RigidMotion> fitted,
                             const AskedNodes& nodes, const PathSide& side,
                             std::span<const Vec3> goal) {
  std::vector<PieceTurn> turns = turns_of(nodes.start, tree, fitted);
  const auto most = std::max_element(
      turns.begin(), turns.end(),
      [](const PieceTurn& one, const PieceTurn& other) { return one.angle < other.angle; });
  if (most == turns.end() || most->angle < least_turn) return {};
  std::vector<Vec3> end;
  for (const Vec3 x : nodes.end) end.push_back(inverse(fitted[0])(x));
  std::vector<TurnWay> found;
  const int senses = most->angle > least_two_way ? 2 : 1;
  for (int sense = 0; sense < senses; ++sense) {
    TurnGuess guess(nodes.start, tree, end, turns, most->piece);
    found.push_back(way_of(guess, nodes, side, goal));
    found.back().angle = most->angle / degree;
    most->axis *= -1.0;
    most->angle = 2.0 * std::numbers::pi - most->angle;
  }
  return found;
}

}  // namespace

std::vector<TurnWay> find_turn_ways(const PathSide& start, std::span<const Vec3> goal) {
  const AskedNodes nodes = nodes_of(start, goal);
  for (const PieceTree& tree : find_pieces(nodes.start, nodes.end)) {
    const std::vector<RigidMotion> fitted = fits(nodes, tree);
    if (!explain(fitted, tree, nodes)) continue;
    std::vector<TurnWay> found = ways_by(tree, fitted, nodes, start, goal);
    std::stable_sort(found.begin(), found.end(), [](const TurnWay& one, const TurnWay& other) {
      return one.clashes < other.clashes;
    });
    return found;
  }
  return {};
}

}  // namespace pliant
