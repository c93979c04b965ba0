// SPDX-License-Identifier: MIT
#include "pliant/fit/residue_sites.hpp"

#include <array>
#include <cmath>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

constexpr double backbone = 2.6;     // Angstrom from an alpha carbon: N, C, O and CB
constexpr double least_area = 1e-3;  // Angstrom^2, of u x v: less is a straight chain

/// From a node to the next one and to the one before.
struct Neighbours {
  Vec3 u, v;
  Neighbours(std::span<const Vec3> nodes, std::uint32_t node)
      : u(nodes[node + 1] - nodes[node]), v(nodes[node - 1] - nodes[node]) {}
  Vec3 normal() const { return cross(u, v); }
};

bool is_linked(const FitNodes& nodes, std::uint32_t node) {
  if (node == 0 || node + 1 == nodes.positions.size()) return false;
  return nodes.chain[node - 1] == nodes.chain[node + 1] &&
         norm_squared(Neighbours(nodes.positions, node).normal()) > least_area;
}

/// a, b, c of `arm` = a u + b v + c u x v.
Vec3 local_of(const Neighbours& by, Vec3 arm) {
  const Vec3 n = by.normal();
  const double area = norm_squared(n);
  return {dot(cross(arm, by.v), n) / area, dot(cross(by.u, arm), n) / area, dot(arm, n) / area};
}

}  // namespace

ResidueSite residue_site(const FitNodes& nodes, std::uint32_t node, Vec3 arm, double weight) {
  ResidueSite site{node, is_linked(nodes, node), weight, {}};
  if (site.has_frame) site.local = local_of({nodes.positions, node}, arm);
  return site;
}

ResidueSites::ResidueSites(const FitNodes& nodes, std::span<const Vec3> atoms,
                           std::span<const double> weights, std::span<const std::uint32_t> node_of,
                           std::size_t parts)
    : nodes_(nodes.positions.size()) {
  struct Mass {
    double weight = 0.0;
    Vec3 moment;
  };
  std::vector<std::array<Mass, 2>> masses(nodes.positions.size());
  for (std::size_t k = 0; k < atoms.size(); ++k) {
    const Vec3 arm = atoms[k] - nodes.positions[node_of[k]];
    Mass& mass = masses[node_of[k]][parts > 1 && norm_squared(arm) > backbone * backbone ? 1 : 0];
    mass.weight += weights[k];
    mass.moment += weights[k] * arm;
  }
  for (std::uint32_t node = 0; node < masses.size(); ++node)
    for (const Mass& mass : masses[node]) {
      if (mass.weight == 0.0) continue;
      const Vec3 arm = (1.0 / mass.weight) * mass.moment;
      sites_.push_back(residue_site(nodes, node, arm, mass.weight));
    }
}

std::vector<Vec3> ResidueSites::places(std::span<const Vec3> nodes) const {
  std::vector<Vec3> out;
  out.reserve(sites_.size());
  for (const ResidueSite& site : sites_) {
    Vec3 place = nodes[site.node];
    if (site.has_frame) {
      const Neighbours by(nodes, site.node);
      place += site.local.x * by.u + site.local.y * by.v + site.local.z * by.normal();
    }
    out.push_back(place);
  }
  return out;
}

void ResidueSites::add_gradient(std::span<const Vec3> nodes, std::span<const Vec3> by_place,
                                std::span<Vec3> gradient) const {
  for (std::size_t k = 0; k < sites_.size(); ++k) {
    const ResidueSite& site = sites_[k];
    const Vec3 slope = by_place[k];
    gradient[site.node] += slope;
    if (!site.has_frame) continue;
    const Neighbours by(nodes, site.node);
    const Vec3 next = site.local.x * slope + site.local.z * cross(by.v, slope);
    const Vec3 before = site.local.y * slope + site.local.z * cross(slope, by.u);
    gradient[site.node + 1] += next;
    gradient[site.node - 1] += before;
    gradient[site.node] -= next + before;
  }
}

}  // namespace pliant
