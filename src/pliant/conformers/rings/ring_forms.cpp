// SPDX-License-Identifier: MIT
#include "pliant/conformers/rings/ring_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/base/math/superposition.hpp"
#include "pliant/conformers/rings/distance_fit.hpp"

namespace pliant {
namespace {

constexpr double least_difference = 0.15;       // Angstrom, r.m.s.
constexpr double least_difference_five = 0.08;  // envelopes 36 degrees apart differ by 0.11

/// Steps towards distances that need not be met; larger damping leaves more as it is.
constexpr int relaxing_steps = 8;
constexpr double relaxing = 0.05;
/// All ten distances of a ring of five leave it no other form than its mirror image.
constexpr double relaxing_five = 1.0;
constexpr double pucker_of_five = 0.4;  // Angstrom, that of cyclopentane and proline

/// Distances across one bond, up to `most` bonds.
std::vector<WantedDistance> distances_of(std::span<const Vec3> ring, std::size_t most) {
  std::vector<WantedDistance> all;
  for (std::size_t step = 1; step <= most; ++step)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = (i + step) % ring.size();
      all.push_back({i, j, norm_squared(ring[i] - ring[j])});
    }
  return all;
}

/// An even hexagon with these heights.
std::vector<Vec3> hexagon(const std::array<double, 6>& heights) {
  constexpr double half = 0.5, side = 0.8660254037844386, radius = 1.45;
  constexpr std::array<Vec3, 6> corners{{{1.0, 0.0, 0.0},
                                         {half, side, 0.0},
                                         {-half, side, 0.0},
                                         {-1.0, 0.0, 0.0},
                                         {-half, -side, 0.0},
                                         {half, -side, 0.0}}};
  std::vector<Vec3> x(6);
  for (std::size_t k = 0; k < 6; ++k) x[k] = radius * corners[k] + Vec3{0.0, 0.0, heights[k]};
  return x;
}

/// Meets the bonds and comes near to the angles.
bool relax(std::span<const Vec3> ring, std::vector<Vec3>& x) {
  const std::vector<WantedDistance> all = distances_of(ring, 2);
  if (ring.size() == 5) approach(all, relaxing_five, x);
  if (ring.size() == 6)
    for (int step = 0; step < relaxing_steps; ++step) approach(all, relaxing, x);
  return meet(distances_of(ring, 1), x);
}

double torsion_sign(Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return dot(cross(b - a, c - b), d - c); }

void add_if_new(std::vector<Vec3> x, std::vector<RingForm>& forms) {
  for (const RingForm& known : forms) {
    const RigidMotion onto = superposition(x, known.positions);
    double sum = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) sum += norm_squared(onto(x[k]) - known.positions[k]);
    const double least = x.size() == 5 ? least_difference_five : least_difference;
    if (sum < double(x.size()) * least * least) return;
  }
  const bool chair = is_chair(x);
  forms.push_back({std::move(x), chair});
}

/// An even pentagon as ten envelopes, z_k = q sqrt(2/5) cos(phi + 4 pi k / 5), phi in steps of 36
/// degrees.
std::vector<std::vector<Vec3>> pentagons() {
  // cos and sin of 72 and 36 degrees.
  constexpr double c = 0.30901699437494745, s = 0.9510565162951535, c36 = 0.8090169943749475,
                   s36 = 0.5877852522924731, radius = 1.29, share = 0.6324555320336759;
  std::vector<std::vector<Vec3>> all;
  Vec3 phase{1.0, 0.0, 0.0};
  for (int m = 0; m < 10; ++m) {
    std::vector<Vec3> x;
    Vec3 corner{1.0, 0.0, 0.0}, angle = phase;
    for (int k = 0; k < 5; ++k) {
      x.push_back({radius * corner.x, radius * corner.y, pucker_of_five * share * angle.x});
      corner = {c * corner.x - s * corner.y, s * corner.x + c * corner.y, 0.0};
      angle = {-c36 * angle.x - s36 * angle.y, s36 * angle.x - c36 * angle.y, 0.0};
    }
    all.push_back(std::move(x));
    phase = {c36 * phase.x - s36 * phase.y, s36 * phase.x + c36 * phase.y, 0.0};
  }
  return all;
}

/// Even hexagons as a chair and the six twist-boats.
std::vector<std::vector<Vec3>> hexagons() {
  constexpr double chair = 0.25, boat = 0.38;
  std::vector<std::vector<Vec3>> all{hexagon({chair, -chair, chair, -chair, chair, -chair})};
  for (std::size_t k = 0; k < 3; ++k)
    for (double up : {boat, -boat}) {
      std::array<double, 6> heights{};
      for (std::size_t m = 0; m < 6; ++m)
        heights[m] = m % 3 == k ? 0.0 : ((m + 3 - k) % 3 == 1 ? up : -up);
      all.push_back(hexagon(heights));
    }
  return all;
}

double torsion_cosine(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 one = cross(b - a, c - b), other = cross(c - b, d - c);
  return dot(one, other) / (norm(one) * norm(other));
}

/// Whether double bonds and the like are turned no further than they were.
bool keeps_flat(std::span<const Vec3> ring, const std::vector<bool>& is_flat,
                std::span<const Vec3> x) {
  constexpr double cosine_12 = 0.9781476007338057, sine_12 = 0.20791169081775934;
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before = (k + n - 1) % n, after = (k + 1) % n, last = (k + 2) % n;
    if (!is_flat[k] || !is_flat[after]) continue;
    const double was = torsion_cosine(ring[before], ring[k], ring[after], ring[last]);
    const double least = was * cosine_12 - std::sqrt(std::max(0.0, 1.0 - was * was)) * sine_12;
    if (torsion_cosine(x[before], x[k], x[after], x[last]) < least) return false;
  }
  return true;
}

void add_mirrored(std::vector<RingForm>& forms) {
  const std::size_t found = forms.size();
  for (std::size_t k = 0; k < found; ++k) {
    std::vector<Vec3> mirrored = forms[k].positions;
    for (Vec3& x : mirrored) x.z = -x.z;
    add_if_new(std::move(mirrored), forms);
  }
}

}  // namespace

bool is_chair(std::span<const Vec3> x) {
  if (x.size() != 6) return false;
  std::array<double, 6> signs{};
  for (std::size_t k = 0; k < 6; ++k)
    signs[k] = torsion_sign(x[k], x[(k + 1) % 6], x[(k + 2) % 6], x[(k + 3) % 6]);
  for (std::size_t k = 0; k < 6; ++k)
    if (!(signs[k] * signs[(k + 1) % 6] < 0.0)) return false;
  return true;
}

std::vector<RingForm> ring_forms(std::span<const Vec3> ring, const std::vector<bool>& is_flat) {
  std::vector<RingForm> forms{{{ring.begin(), ring.end()}, is_chair(ring)}};
  std::vector<std::vector<Vec3>> seeds;
  if (ring.size() == 5) seeds = pentagons();
  if (ring.size() == 6) seeds = hexagons();
  if (ring.size() == 6) {
    const std::vector<WantedDistance> wanted = distances_of(ring, 2);
    for (std::vector<Vec3> x : seeds)
      if (meet(wanted, x) && keeps_flat(ring, is_flat, x)) add_if_new(std::move(x), forms);
  }
  add_mirrored(forms);
  for (std::vector<Vec3>& x : seeds)
    if (relax(ring, x) && keeps_flat(ring, is_flat, x)) add_if_new(std::move(x), forms);
  add_mirrored(forms);
  return forms;
}

}  // namespace pliant
