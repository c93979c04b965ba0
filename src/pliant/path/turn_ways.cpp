// SPDX-License-Identifier: MIT
#include "pliant/path/turn_ways.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "pliant/base/math/axis_angle.hpp"
#include "pliant/base/math/elementary.hpp"
#include "pliant/base/math/superposition.hpp"
#include "pliant/path/path_walker.hpp"
#include "pliant/sample/turns/turn_course.hpp"

namespace pliant {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double least_angle =
    45.0 * degree;  // the chord of a smaller turn is within 8 % of its arc
constexpr double long_way =
    120.0 * degree;                       // from here the other way round is at most twice as far
constexpr double most_unexplained = 0.5;  // of the distance, r.m.s., by pieces that keep shape
constexpr double lift = 10.0;      // Angstrom by which the piece is apart from the rest half-way
constexpr double goal_step = 1.0;  // Angstrom, r.m.s. distance of goals
constexpr double clash = 4.0;      // Angstrom; nodes of two pieces that are nearer clash
constexpr int looks = 20;          // at a way, for its length and clashes
constexpr std::int64_t lift_smooth = 4;  // nodes on each side over which the lift is spread

RigidMotion inverse_of(const RigidMotion& motion) {
  const Rotation back = inverse(motion.rotation);
  return {back, -1.0 * back(motion.shift)};
}

/// The residues that are asked to move, each at the middle of its asked atoms.
struct AskedNodes {
  NetworkNodes start;
  std::vector<Vec3> end;                ///< (M)
  std::vector<std::uint32_t> of_asked;  ///< (K)
};

AskedNodes nodes_of(const PathSide& side, std::span<const Vec3> goal) {
  AskedNodes nodes;
  std::vector<double> counts;
  const AtomTable& atoms = side.model.structure.atoms;
  std::uint32_t chain = 0;
  for (std::size_t k = 0; k < side.asked.size(); ++k) {
    const std::uint32_t atom = side.asked[k];
    if (k == 0 || side.leader[atom] != side.leader[side.asked[k - 1]]) {
      if (k > 0 && atoms.residues[atoms.residue_of[atom]].chain !=
                       atoms.residues[atoms.residue_of[side.asked[k - 1]]].chain)
        ++chain;
      nodes.start.positions.emplace_back();
      nodes.start.chain.push_back(chain);
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

/// Whether pieces that keep their shape come near enough to the end.
bool explains(const AskedNodes& nodes, const PieceTree& tree,
              std::span<const RigidMotion> motions) {
  std::vector<Vec3> left;
  for (std::size_t i = 0; i < nodes.end.size(); ++i)
    left.push_back(nodes.end[i] - motions[tree.of_node[i]](nodes.start.positions[i]));
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

/// The middle of the links between two pieces; of the piece, if no chain joins them.
Vec3 middle_of(const AskedNodes& nodes, const PieceTree& tree, std::uint32_t piece) {
  Vec3 links, all;
  double link_count = 0.0, count = 0.0;
  const auto parent = static_cast<std::uint32_t>(tree.parent[piece]);
  for (const auto [before, after] : tree.links)
    if (std::minmax(tree.of_node[before], tree.of_node[after]) == std::minmax(piece, parent)) {
      links += 0.5 * (nodes.start.positions[before] + nodes.start.positions[after]);
      link_count += 1.0;
    }
  for (std::size_t i = 0; i < tree.of_node.size(); ++i)
    if (tree.of_node[i] == piece) {
      all += nodes.start.positions[i];
      count += 1.0;
    }
  return link_count > 0.0 ? (1.0 / link_count) * links : (1.0 / count) * all;
}

std::vector<PieceTurn> turns_of(const AskedNodes& nodes, const PieceTree& tree,
                                std::span<const RigidMotion> fitted) {
  std::vector<PieceTurn> turns;
  for (std::uint32_t p = 1; p < tree.piece_count(); ++p) {
    const RigidMotion back = inverse_of(fitted[static_cast<std::size_t>(tree.parent[p])]);
    const RigidMotion relative{product(back.rotation, fitted[p].rotation), back(fitted[p].shift)};
    const AxisAngle turn = axis_angle(relative.rotation);
    if (turn.angle < degree) continue;  // its axis is far away
    turns.push_back({.piece = p,
                     .axis = turn.axis,
                     .pivot = point_of_axis(relative, turn, middle_of(nodes, tree, p)),
                     .angle = turn.angle});
  }
  return turns;
}

/// One guess of the way. What turns leave is gone in straight lines meanwhile, seen from the
/// pieces.
class TurnGuess {
 public:
  TurnGuess(const AskedNodes& nodes, const PieceTree& tree, std::span<const Vec3> end,
            std::vector<PieceTurn> turns, std::uint32_t lifted)
      : nodes_(nodes), turns_(std::move(turns)), course_(nodes.start, tree) {
    find_lifted(tree, lifted);
    const auto motions = course_.motions(turns_, 1.0);
    for (std::size_t i = 0; i < end.size(); ++i)
      rest_.push_back(inverse_of(motions[i])(end[i]) - nodes.start.positions[i]);
  }

  /// (M) the motion of each node at a share of the way.
  std::vector<RigidMotion> motions(double share) {
    const auto turned = course_.motions(turns_, share);
    std::vector<RigidMotion> out(turned.begin(), turned.end());
    for (std::size_t i = 0; i < out.size(); ++i) out[i].shift += out[i].rotation(share * rest_[i]);
    const Vec3 up = lift * exact_bits_cos(std::numbers::pi * (share - 0.5)) * direction(out);
    for (std::size_t i = 0; i < out.size(); ++i) out[i].shift += is_lifted_[i] * up;
    return out;
  }

  std::vector<Vec3> places(double share) {
    const std::vector<RigidMotion> now = motions(share);
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < now.size(); ++i) out.push_back(now[i](nodes_.start.positions[i]));
    return out;
  }

  /// How deep nodes of the lifted part are in others, on all of the way (Angstrom^2).
  double clashes() {
    double sum = 0.0;
    for (int look = 1; look < looks; ++look) {
      const std::vector<Vec3> x = places(double(look) / looks);
      for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = i + 1; j < x.size(); ++j) {
          if ((is_lifted_[i] < 0.5) == (is_lifted_[j] < 0.5)) continue;
          const double depth = clash - distance(x[i], x[j]);
          if (depth > 0.0) sum += depth * depth;
        }
    }
    return sum;
  }

  /// r.m.s. length (Angstrom)
  double length() {
    double sum = 0.0;
    std::vector<Vec3> before = nodes_.start.positions;
    for (int look = 1; look <= looks; ++look) {
      std::vector<Vec3> now = places(double(look) / looks);
      sum += rms(ways(before, now));
      before = std::move(now);
    }
    return sum;
  }

  double largest_angle() const {
    double most = 0.0;
    for (const PieceTurn& turn : turns_) most = std::max(most, turn.angle);
    return most;
  }

 private:
  /// The piece and all that hangs on it; beside its links partly.
  void find_lifted(const PieceTree& tree, std::uint32_t lifted) {
    std::vector<std::uint8_t> goes(tree.piece_count(), 0);
    goes[lifted] = 1;
    for (std::uint32_t p = lifted + 1; p < goes.size(); ++p)
      goes[p] = goes[static_cast<std::size_t>(tree.parent[p])];
    const auto last = static_cast<std::int64_t>(tree.of_node.size()) - 1;
    for (std::int64_t i = 0; i <= last; ++i) {
      double sum = 0.0, count = 0.0;
      for (std::int64_t j = std::max<std::int64_t>(0, i - lift_smooth);
           j <= std::min(last, i + lift_smooth); ++j) {
        if (nodes_.start.chain[std::size_t(i)] != nodes_.start.chain[std::size_t(j)]) continue;
        sum += goes[tree.of_node[std::size_t(j)]];
        count += 1.0;
      }
      is_lifted_.push_back(sum / count);
    }
  }

  /// From the middle of the rest to that of the lifted part.
  Vec3 direction(std::span<const RigidMotion> motions) const {
    Vec3 lifted, rest;
    double count = 0.0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const Vec3 x = motions[i](nodes_.start.positions[i]);
      lifted += is_lifted_[i] * x;
      rest += (1.0 - is_lifted_[i]) * x;
      count += is_lifted_[i];
    }
    const Vec3 apart = (1.0 / count) * lifted - (1.0 / (double(motions.size()) - count)) * rest;
    const double length = norm(apart);
    return length > 0.0 ? (1.0 / length) * apart : Vec3{};
  }

  const AskedNodes& nodes_;
  std::vector<PieceTurn> turns_;
  TurnCourse course_;
  std::vector<double> is_lifted_;  ///< (M) 0 to 1
  std::vector<Vec3> rest_;         ///< (M) Angstrom, as each node lies at the start
};

TurnWay way_of(TurnGuess& guess, const AskedNodes& nodes, const PathSide& side,
               std::span<const Vec3> goal) {
  TurnWay way{guess.largest_angle() / degree, {}};
  const int count = std::max(1, int(std::ceil(guess.length() / goal_step)));
  for (int k = 1; k < count; ++k) {
    const std::vector<RigidMotion> motions = guess.motions(double(k) / count);
    std::vector<Vec3>& places = way.goals.emplace_back();
    for (std::size_t a = 0; a < side.asked.size(); ++a)
      places.push_back(motions[nodes.of_asked[a]](side.model.positions[side.asked[a]]));
  }
  way.goals.emplace_back(goal.begin(), goal.end());
  return way;
}

}  // namespace

std::vector<TurnWay> find_turn_ways(const PathSide& start, std::span<const Vec3> goal) {
  const AskedNodes nodes = nodes_of(start, goal);
  std::vector<std::pair<double, TurnWay>> found;
  for (const PieceTree& tree : find_pieces(nodes.start, nodes.end)) {
    const std::vector<RigidMotion> fitted = fits(nodes, tree);
    if (!explains(nodes, tree, fitted)) continue;
    std::vector<PieceTurn> turns = turns_of(nodes, tree, fitted);
    const auto most =
        std::max_element(turns.begin(), turns.end(),
                         [](const PieceTurn& a, const PieceTurn& b) { return a.angle < b.angle; });
    if (most == turns.end() || most->angle < least_angle) break;
    std::vector<Vec3> end;
    for (const Vec3 x : nodes.end) end.push_back(inverse_of(fitted[0])(x));
    const bool is_two_way = most->angle > long_way;
    for (int senses = 0; senses < (is_two_way ? 2 : 1); ++senses) {
      TurnGuess guess(nodes, tree, end, turns, most->piece);
      found.emplace_back(guess.clashes(), way_of(guess, nodes, start, goal));
      most->axis *= -1.0;
      most->angle = 2.0 * std::numbers::pi - most->angle;
    }
    break;
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<TurnWay> out;
  for (auto& [clashes, way] : found) out.push_back(std::move(way));
  return out;
}

}  // namespace pliant
