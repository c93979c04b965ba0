// SPDX-License-Identifier: MIT
#include "pliant/sample/ring_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/base/superposition.hpp"
#include "pliant/resolve/units/dense_solve.hpp"

namespace pliant {
namespace {

constexpr double least_difference = 0.15;  // Angstrom, r.m.s.
constexpr int most_steps = 60;
constexpr double closed = 1e-13;  // of a squared distance
// The twelve equations depend on each other where boats are flexible: a little is added.
constexpr double damping = 1e-9;

/// Distances across one and two bonds of a ring of six.
struct RingDistance {
  std::size_t i, j;
  double square;
};

std::vector<RingDistance> distances_of(std::span<const Vec3> ring) {
  std::vector<RingDistance> all;
  for (std::size_t step = 1; step <= 2; ++step)
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

/// Gauss-Newton of least change until all distances are met.
bool meet(const std::vector<RingDistance>& wanted, std::vector<Vec3>& x) {
  const std::size_t n = wanted.size();
  for (int step = 0; step < most_steps; ++step) {
    std::vector<double> off(n), product(n * n, 0.0);
    double worst = 0.0, largest = 0.0;
    for (std::size_t a = 0; a < n; ++a) {
      off[a] = norm_squared(x[wanted[a].i] - x[wanted[a].j]) - wanted[a].square;
      worst = std::max(worst, std::abs(off[a]) / wanted[a].square);
    }
    if (!(worst > closed)) return std::isfinite(worst);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b <= a; ++b) {
        const auto& [i, j, one] = wanted[a];
        const auto& [k, l, other] = wanted[b];
        const double shared = (i == k ? 1.0 : 0.0) + (j == l ? 1.0 : 0.0) - (i == l ? 1.0 : 0.0) -
                              (j == k ? 1.0 : 0.0);
        product[a * n + b] = 4.0 * shared * dot(x[i] - x[j], x[k] - x[l]);
        largest = std::max(largest, product[a * n + b]);
      }
    for (std::size_t a = 0; a < n; ++a) product[a * n + a] += damping * largest;
    if (!solve_positive(product, off, 0.0)) return false;
    std::vector<Vec3> moved = x;
    for (std::size_t a = 0; a < n; ++a) {
      const Vec3 along = (2.0 * off[a]) * (x[wanted[a].i] - x[wanted[a].j]);
      moved[wanted[a].i] += -1.0 * along;
      moved[wanted[a].j] += along;
    }
    x = moved;
  }
  return false;
}

double torsion_sign(Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return dot(cross(b - a, c - b), d - c); }

bool is_chair(std::span<const Vec3> x) {
  if (x.size() != 6) return false;
  std::array<double, 6> signs{};
  for (std::size_t k = 0; k < 6; ++k)
    signs[k] = torsion_sign(x[k], x[(k + 1) % 6], x[(k + 2) % 6], x[(k + 3) % 6]);
  for (std::size_t k = 0; k < 6; ++k)
    if (!(signs[k] * signs[(k + 1) % 6] < 0.0)) return false;
  return true;
}

void add_if_new(std::vector<Vec3> x, std::vector<RingForm>& forms) {
  for (const RingForm& known : forms) {
    const RigidMotion onto = superposition(x, known.positions);
    double sum = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) sum += norm_squared(onto(x[k]) - known.positions[k]);
    if (sum < double(x.size()) * least_difference * least_difference) return;
  }
  const bool chair = is_chair(x);
  forms.push_back({std::move(x), chair});
}

std::vector<std::array<double, 6>> seeds() {
  constexpr double chair = 0.25, boat = 0.38;
  std::vector<std::array<double, 6>> all{{chair, -chair, chair, -chair, chair, -chair}};
  for (std::size_t k = 0; k < 3; ++k)
    for (double up : {boat, -boat}) {
      std::array<double, 6> heights{};
      for (std::size_t m = 0; m < 6; ++m)
        heights[m] = m % 3 == k ? 0.0 : ((m + 3 - k) % 3 == 1 ? up : -up);
      all.push_back(heights);
    }
  return all;
}

}  // namespace

std::vector<RingForm> ring_forms(std::span<const Vec3> ring) {
  std::vector<RingForm> forms{{{ring.begin(), ring.end()}, is_chair(ring)}};
  if (ring.size() == 6) {
    const std::vector<RingDistance> wanted = distances_of(ring);
    for (const auto& heights : seeds()) {
      std::vector<Vec3> x = hexagon(heights);
      if (meet(wanted, x)) add_if_new(std::move(x), forms);
    }
  }
  const std::size_t found = forms.size();
  for (std::size_t k = 0; k < found; ++k) {
    std::vector<Vec3> mirrored = forms[k].positions;
    for (Vec3& x : mirrored) x.z = -x.z;
    add_if_new(std::move(mirrored), forms);
  }
  return forms;
}

}  // namespace pliant
