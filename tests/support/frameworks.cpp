// SPDX-License-Identifier: MIT
#include "support/frameworks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace pliant::test {

FrameworkParts parts_of(const Framework& framework) {
  FrameworkParts parts = framework.parts();
  parts.atoms = nullptr;
  parts.drawn.clear();
  return parts;
}

Framework with_masses(const Framework& framework) {
  constexpr double masses[] = {12, 1, 16, 14, 1.008, 4};
  FrameworkParts parts = parts_of(framework);
  for (std::size_t i = 0; i < parts.masses.size(); ++i) parts.masses[i] = masses[i % 6];
  return Framework(std::move(parts));
}

Framework with_pinned(const Framework& framework, std::vector<Joint> pinned) {
  FrameworkParts parts = parts_of(framework);
  parts.pinned = std::move(pinned);
  return Framework(std::move(parts));
}

Framework with_swapped_ends(const Framework& framework) {
  FrameworkParts parts = parts_of(framework);
  for (Bar& bar : parts.bars) std::swap(bar.a, bar.b);
  return Framework(std::move(parts));
}

std::shared_ptr<Sterics> spheres(std::size_t joints, double least, int excluded_bonds) {
  auto sterics = std::make_shared<Sterics>();
  sterics->kind_count = 1;
  sterics->kinds.assign(joints, 0);
  sterics->least = {least};
  sterics->excluded_bonds = excluded_bonds;
  return sterics;
}

Framework copies_of(const Framework& framework, std::span<const Vec3> positions, std::size_t count,
                    Vec3 apart) {
  FrameworkParts all{.joint_count = count * positions.size()};
  for (std::size_t k = 0; k < count; ++k) {
    const auto first = static_cast<Joint>(k * positions.size());
    for (Bar bar : framework.bars()) all.bars.push_back({first + bar.a, first + bar.b});
    for (double rest : framework.rest_lengths()) all.rest_lengths.push_back(rest);
    for (Vec3 x : positions) all.drawn.push_back(x + double(k) * apart);
  }
  return Framework(std::move(all));
}

double shortest_bar(const Framework& framework) {
  const auto rests = framework.rest_lengths();
  return rests.empty() ? 1.0 : *std::min_element(rests.begin(), rests.end());
}

std::vector<Vec3> shake(const Framework& framework, std::span<const Vec3> positions, double size,
                        std::uint64_t seed) {
  std::vector<Vec3> shaken(positions.begin(), positions.end());
  for (std::size_t i = 0; i < shaken.size(); ++i)
    if (!framework.is_pinned(static_cast<Joint>(i)))
      shaken[i] += size * RandomSequence({seed, Domain::generate, 0, 0, i}).direction();
  return shaken;
}

std::vector<Vec3> moved_rigidly(std::span<const Vec3> positions) {
  // A rational rotation: the quaternion (1, 2, 3, 4) / sqrt(30).
  constexpr Vec3 rows[] = {{-20. / 30., 4. / 30., 22. / 30.},
                           {20. / 30., -10. / 30., 20. / 30.},
                           {10. / 30., 28. / 30., 4. / 30.}};
  std::vector<Vec3> moved;
  for (Vec3 x : positions)
    moved.push_back(Vec3{dot(rows[0], x), dot(rows[1], x), dot(rows[2], x)} + Vec3{3, -2, 1});
  return moved;
}

double worst_bar(const Framework& framework, std::span<const Vec3> positions) {
  double worst = 0.0;
  for (std::size_t k = 0; k < framework.bar_count(); ++k) {
    const Bar bar = framework.bars()[k];
    const double rest = framework.rest_lengths()[k];
    worst = std::max(worst, std::abs(distance(positions[bar.a], positions[bar.b]) - rest) / rest);
  }
  return worst;
}

double largest_difference(std::span<const Vec3> a, std::span<const Vec3> b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, distance(a[i], b[i]));
  return largest;
}

double extent(std::span<const Vec3> positions) {
  double largest = 1.0;
  for (Vec3 x : positions)
    largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  return largest;
}

Vec3 centre_of_mass(const Framework& framework, std::span<const Vec3> positions) {
  Vec3 sum;
  double mass = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    sum += positions[i] * (1.0 / framework.inverse_masses()[i]);
    mass += 1.0 / framework.inverse_masses()[i];
  }
  return sum * (1.0 / mass);
}

bool all_finite(std::span<const Vec3> positions) {
  return std::all_of(positions.begin(), positions.end(), is_finite);
}

bool same_bits(std::span<const Vec3> a, std::span<const Vec3> b) {
  if (a.empty() || b.empty()) return a.size() == b.size();  // memcmp takes no null
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

std::uint64_t hash_of(std::span<const Vec3> positions, std::uint64_t hash) {
  for (Vec3 x : positions) {
    for (double coordinate : {x.x, x.y, x.z}) {
      auto bits = std::bit_cast<std::uint64_t>(coordinate);
      for (int byte = 0; byte < 8; ++byte, bits >>= 8)
        hash = (hash ^ (bits & 0xff)) * 0x100000001b3u;
    }
  }
  return hash;
}

}  // namespace pliant::test
