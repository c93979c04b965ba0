// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/hinges.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "pliant/base/math/best_fit.hpp"
#include "pliant/base/math/cell_list.hpp"
#include "pliant/sample/turns/screw.hpp"

namespace pliant {
namespace {

/// Pairs that are no neighbours along a chain.
template <class Visit>
void for_each_near(double length, const NetworkNodes& nodes, std::span<const Vec3> at,
                   const Visit& visit) {
  CellList(at, length * nodes.scale).for_each_pair([&](std::uint32_t i, std::uint32_t j, double) {
    if (nodes.chain[i] != nodes.chain[j] || j - i > 2) visit(i, j);
  });
}

/// 1 for nodes that move with a piece, 0 for others.
std::vector<std::uint32_t> moved_with(const PieceTree& tree, std::uint32_t piece) {
  std::vector<std::uint32_t> pieces(tree.piece_count(), 0), nodes;
  pieces[piece] = 1;
  for (std::uint32_t p = piece + 1; p < pieces.size(); ++p)
    pieces[p] = pieces[static_cast<std::size_t>(tree.parent[p])];
  for (const std::uint32_t p : tree.of_node) nodes.push_back(pieces[p]);
  return nodes;
}

using Matrix = std::array<double, 9>;

/// One row for each component of `one`.
void add_product(Vec3 one, Vec3 other, Matrix& sum) {
  const std::array<double, 3> x{one.x, one.y, one.z}, y{other.x, other.y, other.z};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) sum[3 * a + b] += x[a] * y[b];
}

Vec3 product(const Matrix& m, Vec3 x) {
  const auto row = [&](std::size_t a) { return dot({m[a], m[a + 1], m[a + 2]}, x); };
  return {row(0), row(3), row(6)};
}

/// The direction in which points are spread furthest.
Vec3 line_through(std::span<const Vec3> points, Vec3 centre) {
  if (points.size() < 2) return {};
  std::array<double, 9> spread{}, vectors{};
  for (const Vec3 point : points) add_product(point - centre, point - centre, spread);
  find_eigenvectors(spread, vectors, 3);
  std::size_t most = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (spread[4 * k] > spread[4 * most]) most = k;
  return {vectors[most], vectors[3 + most], vectors[6 + most]};
}

/// Covariances of how both sides turn against each other in the modes, and of how they shift with
/// it.
struct MovesInModes {
  Matrix turns{}, shifts{};
};

MovesInModes moves_in_modes(const NetworkNodes& nodes, const NetworkModes& modes,
                            std::span<const std::uint32_t> sides) {
  MovesInModes sum;
  std::vector<Vec3> moves(nodes.positions.size());
  for (std::size_t k = 0; k < modes.variances.size(); ++k) {
    const double scale = std::sqrt(modes.variances[k]);
    const auto u = modes.directions.row(k);
    for (std::size_t i = 0; i < moves.size(); ++i)
      moves[i] = scale * Vec3{u[3 * i], u[3 * i + 1], u[3 * i + 2]};
    const Screw one = screw_of(nodes.positions, moves, sides, 1);
    const Screw other = screw_of(nodes.positions, moves, sides, 0);
    add_product(one.turn - other.turn, one.turn - other.turn, sum.turns);
    add_product(one.shift - other.shift, one.turn - other.turn, sum.shifts);
  }
  return sum;
}

void find_axes(MovesInModes moves, Hinge& hinge) {
  Matrix vectors{}, &turns = moves.turns;
  find_eigenvectors(turns, vectors, 3);
  const double trace = turns[0] + turns[4] + turns[8];
  for (std::size_t k = 0; k < 3; ++k) {
    hinge.axes[k] = {vectors[k], vectors[3 + k], vectors[6 + k]};
    hinge.softness[k] = trace > 0.0 ? turns[4 * k] / trace : 1.0 / 3.0;
    if (turns[4 * k] > 1e-9 * trace)
      hinge.shifts[k] = (1.0 / turns[4 * k]) * product(moves.shifts, hinge.axes[k]);
  }
}

void find_links(const NetworkNodes& nodes, const PieceTree& tree,
                std::span<const std::uint32_t> sides, Hinge& hinge) {
  for (const auto [before, after] : tree.links)
    if (sides[before] != sides[after])
      hinge.middles.push_back(0.5 * (nodes.positions[before] + nodes.positions[after]));
  const std::span<const Vec3> points = hinge.middles.empty() ? nodes.positions : hinge.middles;
  for (const Vec3 point : points) hinge.centre += (1.0 / double(points.size())) * point;
  hinge.line = line_through(hinge.middles, hinge.centre);
}

Hinge hinge_of(const NetworkNodes& nodes, const PieceTree& tree, const NetworkModes& modes,
               std::uint32_t piece) {
  const std::vector<std::uint32_t> sides = moved_with(tree, piece);
  const double size = double(std::count(sides.begin(), sides.end(), 1u));
  const double smaller = std::min(size, double(sides.size()) - size);
  Hinge hinge;
  hinge.piece = piece;
  hinge.weight = smaller * smaller / double(sides.size() * sides.size());
  find_links(nodes, tree, sides, hinge);
  find_axes(moves_in_modes(nodes, modes, sides), hinge);
  return hinge;
}

}  // namespace

std::vector<Hinge> hinges_of(const NetworkNodes& nodes, const PieceTree& tree,
                             const NetworkModes& modes) {
  std::vector<Hinge> hinges;
  for (std::uint32_t piece = 1; piece < tree.piece_count(); ++piece)
    hinges.push_back(hinge_of(nodes, tree, modes, piece));
  return hinges;
}

std::size_t pairs_within(double length, const NetworkNodes& nodes, std::span<const Vec3> moved) {
  std::size_t count = 0;
  for_each_near(length, nodes, moved, [&](std::uint32_t, std::uint32_t) { ++count; });
  return count;
}

}  // namespace pliant
