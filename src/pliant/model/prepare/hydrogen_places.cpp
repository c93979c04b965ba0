// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/hydrogen_places.hpp"

#include <array>
#include <cmath>

namespace pliant {
namespace {

constexpr double too_short = 1e-12;  // squared, of what should have a direction

// Half of the tetrahedral angle.
constexpr double half_cosine = 0.5771451900372336, half_sine = 0.8166415551616789;

// Three bonds in a plane: the sum of their directions is shorter than this. It is 0 in a plane and
// 1 at tetrahedral angles.
constexpr double most_out_of_plane = 0.5;

}  // namespace

Vec3 perpendicular_to(Vec3 u) {
  const Vec3 axis = std::abs(u.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 across = cross(u, axis);
  return (1.0 / norm(across)) * across;
}

Vec3 unit_vector(Vec3 v) {
  const double squared = norm_squared(v);
  if (squared < too_short) return {0.0, 0.0, 1.0};
  return (1.0 / std::sqrt(squared)) * v;
}

bool is_planar(const Structure& structure, const AtomGraph& graph, std::uint32_t atom) {
  Vec3 sum;
  for (const Link& link : graph.at(atom))
    sum += unit_vector(structure.positions[link.node] - structure.positions[atom]);
  return norm(sum) < most_out_of_plane;
}

double cosine_of_tens(int tens) {
  static constexpr std::array<double, 10> quarter{1.0,
                                                  0.984807753012208,
                                                  0.9396926207859084,
                                                  0.8660254037844386,
                                                  0.766044443118978,
                                                  0.6427876096865394,
                                                  0.5,
                                                  0.3420201433256687,
                                                  0.17364817766693033,
                                                  0.0};
  const int turn = ((tens % 36) + 36) % 36;
  const int half = turn <= 18 ? turn : 36 - turn;
  return half <= 9 ? quarter[std::size_t(half)] : -quarter[std::size_t(18 - half)];
}

Spin::Spin(Vec3 reference, Vec3 neighbour, Vec3 parent)
    : parent_(parent), along_(unit_vector(parent - neighbour)) {
  const Vec3 normal = cross(neighbour - reference, along_);
  across_ = norm_squared(normal) < too_short ? perpendicular_to(along_) : unit_vector(normal);
  beside_ = cross(across_, along_);
}

Vec3 Spin::at(double length, BondAngle angle, int tens) const {
  const Vec3 around = cosine_of_tens(tens) * beside_ + cosine_of_tens(tens - 9) * across_;
  return parent_ + length * (angle.sine * around - angle.cosine * along_);
}

Vec3 against_both(Vec3 parent, Vec3 one, Vec3 other, double length) {
  const Vec3 first = unit_vector(one - parent), sum = first + unit_vector(other - parent);
  if (norm_squared(sum) < too_short) return parent + length * perpendicular_to(first);
  return parent - length * unit_vector(sum);
}

Vec3 against_three(Vec3 parent, Vec3 one, Vec3 other, Vec3 third, double length) {
  const Vec3 sum =
      unit_vector(one - parent) + unit_vector(other - parent) + unit_vector(third - parent);
  return parent - length * unit_vector(sum);
}

Vec3 out_of_plane(Vec3 parent, Vec3 one, Vec3 other, double length, double side) {
  const Vec3 back = unit_vector(against_both(parent, one, other, 1.0) - parent);
  Vec3 normal = cross(one - parent, other - parent);
  normal = norm_squared(normal) < too_short ? perpendicular_to(back) : unit_vector(normal);
  return parent + length * (half_cosine * back + side * half_sine * normal);
}

}  // namespace pliant
