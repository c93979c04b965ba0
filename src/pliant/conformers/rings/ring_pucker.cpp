// SPDX-License-Identifier: MIT
#include "pliant/conformers/rings/ring_pucker.hpp"

#include <algorithm>

namespace pliant {
namespace {

constexpr double flat_ring = 0.1;  // Angstrom: a ring so near a plane has no other form

Vec3 centre_of(const SimpleRing& ring, std::span<const Vec3> x) {
  Vec3 sum{};
  for (Joint atom : ring) sum += x[atom];
  return (1.0 / double(ring.size())) * sum;
}

/// Normal of the ring's mean plane (Newell).
Vec3 normal_of(const SimpleRing& ring, std::span<const Vec3> x) {
  const Vec3 centre = centre_of(ring, x);
  Vec3 sum{};
  for (std::size_t k = 0; k < ring.size(); ++k)
    sum += cross(x[ring[k]] - centre, x[ring[(k + 1) % ring.size()]] - centre);
  return (1.0 / norm(sum)) * sum;
}

double out_of_plane(const SimpleRing& ring, std::span<const Vec3> x) {
  const Vec3 centre = centre_of(ring, x), normal = normal_of(ring, x);
  double furthest = 0.0;
  for (Joint atom : ring) furthest = std::max(furthest, std::abs(dot(x[atom] - centre, normal)));
  return furthest;
}

}  // namespace

std::vector<SimpleRing> puckered_rings(const BondChemistry& chemistry,
                                       std::span<const Vec3> start) {
  std::vector<SimpleRing> rings = chemistry.simple_rings();
  std::erase_if(rings,
                [&](const SimpleRing& ring) { return out_of_plane(ring, start) < flat_ring; });
  return rings;
}

void sort_pairs(std::vector<Bar>& pairs) {
  const auto before = [](Bar x, Bar y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
  const auto is_same = [](Bar x, Bar y) { return x.a == y.a && x.b == y.b; };
  std::sort(pairs.begin(), pairs.end(), before);
  pairs.erase(std::unique(pairs.begin(), pairs.end(), is_same), pairs.end());
}

std::vector<Bar> ring_angles(const SimpleRing& ring, const BondChemistry& chemistry) {
  std::vector<Bar> pairs;
  const std::size_t n = ring.size();
  if (n > largest_small_ring) return pairs;
  for (std::size_t k = 0; k < n; ++k)
    for (Joint side : {ring[(k + 1) % n], ring[(k + n - 1) % n]})
      for (const Link& bond : chemistry.bonds_at(ring[k]))
        if (bond.node != side)
          pairs.push_back({std::min(side, bond.node), std::max(side, bond.node)});
  sort_pairs(pairs);
  return pairs;
}

}  // namespace pliant
