// SPDX-License-Identifier: MIT
#include "pliant/conformers/rings/ring_moves.hpp"

#include "pliant/base/math/superposition.hpp"
#include "pliant/conformers/rings/ring_pucker.hpp"
#include "pliant/conformers/rings/ring_systems.hpp"
#include "pliant/conformers/rings/system_forms.hpp"

namespace pliant {
namespace {

Vec3 unit(Vec3 v) { return (1.0 / norm(v)) * v; }

/// Three vectors of length 1 at right angles.
struct Axes {
  Vec3 x, y, z;
};

/// Axes given by two bonds from one atom.
Axes axes_of(Vec3 one, Vec3 other) {
  const Vec3 x = unit(one + other), z = unit(cross(one, other));
  return {x, cross(z, x), z};
}

/// Positions of a ring before and after.
struct Change {
  std::span<const Vec3> old, now;
};

/// What hangs on an atom with two bonds of the ring turns with both alike.
void turn_by_two(const FlexibleRing& ring, std::size_t k, Change ring_at, std::span<Vec3> x) {
  const auto [old, now] = ring_at;
  const std::size_t one = ring.neighbours[k][0], other = ring.neighbours[k][1];
  const Axes was = axes_of(old[one] - old[k], old[other] - old[k]);
  const Axes is = axes_of(now[one] - now[k], now[other] - now[k]);
  for (Joint joint : ring.branches[k]) {
    const Vec3 r = x[joint] - old[k];
    x[joint] = now[k] + dot(r, was.x) * is.x + dot(r, was.y) * is.y + dot(r, was.z) * is.z;
  }
}

/// What hangs on an atom with more bonds of the ring turns as they do on the whole.
void turn_by_all(const FlexibleRing& ring, std::size_t k, Change ring_at, std::span<Vec3> x) {
  std::vector<Vec3> was{ring_at.old[k]}, is{ring_at.now[k]};
  for (std::size_t at : ring.neighbours[k]) {
    was.push_back(ring_at.old[at]);
    is.push_back(ring_at.now[at]);
  }
  const RigidMotion onto = superposition(was, is);
  const Vec3 shift = ring_at.now[k] - onto(ring_at.old[k]);
  for (Joint joint : ring.branches[k]) x[joint] = onto(x[joint]) + shift;
}

FlexibleRing alone(const SimpleRing& atoms, const BondChemistry& chemistry,
                   std::span<const Vec3> start) {
  std::vector<Vec3> positions;
  std::vector<bool> is_flat;
  FlexibleRing ring{atoms, {}, {}, ring_angles(atoms, chemistry), {}};
  const std::size_t n = atoms.size();
  for (std::size_t k = 0; k < n; ++k) {
    positions.push_back(start[atoms[k]]);
    is_flat.push_back(chemistry.is_conjugated(atoms[k]));
    ring.neighbours.push_back({(k + n - 1) % n, (k + 1) % n});
  }
  ring.forms = ring_forms(positions, is_flat);
  return ring;
}

}  // namespace

void take_form(const FlexibleRing& ring, const RingForm& form, std::span<Vec3> x) {
  const std::size_t n = ring.atoms.size();
  std::vector<Vec3> old(n), now(n);
  for (std::size_t k = 0; k < n; ++k) old[k] = x[ring.atoms[k]];
  const RigidMotion onto = superposition(form.positions, old);
  for (std::size_t k = 0; k < n; ++k) now[k] = onto(form.positions[k]);
  for (std::size_t k = 0; k < n; ++k) {
    if (ring.neighbours[k].size() == 2)
      turn_by_two(ring, k, {old, now}, x);
    else
      turn_by_all(ring, k, {old, now}, x);
    x[ring.atoms[k]] = now[k];
  }
}

std::vector<FlexibleRing> flexible_rings(const Framework& framework, const BondChemistry& chemistry,
                                         std::span<const Vec3> start, RingsAsked asked) {
  std::vector<FlexibleRing> rings;
  const std::vector<RingSystem> none;
  if (framework.atoms() == nullptr) return rings;
  for (const SimpleRing& atoms : puckered_rings(chemistry, start))
    if (asked.large || atoms.size() <= largest_small_ring)
      rings.push_back(alone(atoms, chemistry, start));
  for (const RingSystem& system : asked.systems ? ring_systems(chemistry) : none)
    rings.push_back({system.atoms,
                     system.neighbours,
                     {},
                     system_angles(system, chemistry),
                     system_forms(system, framework, chemistry, start)});
  for (FlexibleRing& ring : rings)
    for (Joint atom : ring.atoms) ring.branches.push_back(chemistry.beyond(atom, ring.atoms));
  return rings;
}

std::vector<Bar> soft_pairs(const Framework& framework, const BondChemistry& chemistry,
                            std::span<const Vec3> start, bool with_systems) {
  std::vector<Bar> pairs;
  if (framework.atoms() == nullptr) return pairs;
  for (const SimpleRing& ring : puckered_rings(chemistry, start))
    for (Bar pair : ring_angles(ring, chemistry)) pairs.push_back(pair);
  if (!with_systems) return pairs;
  for (const RingSystem& system : ring_systems(chemistry)) {
    if (system_forms(system, framework, chemistry, start, 2).size() < 2) continue;
    for (Bar pair : system_angles(system, chemistry)) pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace pliant
