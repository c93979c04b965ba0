// SPDX-License-Identifier: MIT
#include "pliant/sample/network/mode_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/math/cell_list.hpp"

namespace pliant {
namespace {

constexpr double turn_reach = 8.0;  // Angstrom, between residues
/// Neighbours on one line say nothing of a turn about it.
constexpr double flat = 1e-6;

std::uint32_t nearest_node(std::span<const Vec3> nodes, Vec3 x) {
  const auto nearer = [&](Vec3 a, Vec3 b) { return norm_squared(a - x) < norm_squared(b - x); };
  return static_cast<std::uint32_t>(std::min_element(nodes.begin(), nodes.end(), nearer) -
                                    nodes.begin());
}

/// Inverse of [xx xy xz; xy yy yz; xz yz zz]; all 0 if it is nearly singular.
std::array<double, 9> inverse_of(double xx, double xy, double xz, double yy, double yz, double zz) {
  const double a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
  const double det = xx * a + xy * b + xz * c;
  const double size = (xx + yy + zz) / 3.0;
  if (!(det > flat * size * size * size)) return {};
  const double s = 1.0 / det;
  return {s * a,
          s * b,
          s * c,
          s * b,
          s * (xx * zz - xz * xz),
          s * (xy * xz - xx * yz),
          s * c,
          s * (xy * xz - xx * yz),
          s * (xx * yy - xy * xy)};
}

}  // namespace

std::vector<std::uint32_t> nodes_of_joints(const NetworkNodes& nodes, std::span<const Vec3> start) {
  std::vector<std::uint32_t> of_joint = nodes.of_joint;
  for (std::size_t j = 0; j < start.size(); ++j)
    if (of_joint[j] == no_node) of_joint[j] = nearest_node(nodes.positions, start[j]);
  return of_joint;
}

ModeDisplacement::ModeDisplacement(const NetworkNodes& nodes, NetworkModes modes,
                                   std::span<const Vec3> start)
    : modes_(std::move(modes)),
      nodes_(nodes.positions),
      start_(start.begin(), start.end()),
      of_joint_(nodes_of_joints(nodes, start)) {
  add_turns(turn_reach * nodes.scale);
}

void ModeDisplacement::add_turns(double reach) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  CellList(nodes_, reach).for_each_pair([&](std::uint32_t i, std::uint32_t j, double) {
    pairs.emplace_back(i, j);
    pairs.emplace_back(j, i);
  });
  std::sort(pairs.begin(), pairs.end());
  neighbours_ = Grouped<std::uint32_t>(nodes_.size(), [&](const auto& put) {
    for (const auto& [i, j] : pairs) put(i, j);
  });
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;
    for (std::uint32_t j : neighbours_.at(i)) {
      const Vec3 r = nodes_[j] - nodes_[i];
      xx += r.y * r.y + r.z * r.z;
      yy += r.x * r.x + r.z * r.z;
      zz += r.x * r.x + r.y * r.y;
      xy -= r.x * r.y;
      xz -= r.x * r.z;
      yz -= r.y * r.z;
    }
    inverse_.push_back(inverse_of(xx, xy, xz, yy, yz, zz));
  }
}

Vec3 ModeDisplacement::turn_of(std::size_t node, std::span<const Vec3> moves) const {
  Vec3 b;
  for (std::uint32_t j : neighbours_.at(node))
    b += cross(nodes_[j] - nodes_[node], moves[j] - moves[node]);
  const auto& m = inverse_[node];
  return {m[0] * b.x + m[1] * b.y + m[2] * b.z, m[3] * b.x + m[4] * b.y + m[5] * b.z,
          m[6] * b.x + m[7] * b.y + m[8] * b.z};
}

void ModeDisplacement::displacements(std::span<const double> amplitudes,
                                     std::span<Vec3> out) const {
  const std::vector<Vec3> moves = moves_along(modes_, amplitudes);
  std::vector<Vec3> turns(moves.size());
  std::vector<double> share(moves.size(), 1.0);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    turns[i] = turn_of(i, moves);
    const double length = norm(moves[i]);
    if (length > largest_node_move) share[i] = largest_node_move / length;
  }
  for (std::size_t j = 0; j < out.size(); ++j) {
    const std::uint32_t i = of_joint_[j];
    out[j] = share[i] * (moves[i] + cross(turns[i], start_[j] - nodes_[i]));
  }
}

}  // namespace pliant
