// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/plausible_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/math/elementary.hpp"
#include "pliant/base/math/superposition.hpp"
#include "pliant/sample/network/softness.hpp"

namespace pliant {
namespace {

// The line of least squares through 58 starts of known pairs (data/make_known_pairs.py): the
// logarithms of distance (Angstrom) and softness.
constexpr double at_softness_1 = 2.07, a_softness = 0.56;

// Radius of gyration over the cube root of the nodes (Angstrom): open proteins have more.
constexpr double half_open = 2.97, open_width = 0.15;

constexpr double of_distance = 1.6, of_gyration = 20.0;

double gyration_of(std::span<const Vec3> points) {
  Vec3 centre;
  for (const Vec3 point : points) centre += (1.0 / double(points.size())) * point;
  double sum = 0.0;
  for (const Vec3 point : points) sum += norm_squared(point - centre);
  return std::sqrt(sum / double(points.size()));
}

/// R.m.s., once one is superposed on the other.
double distance_of(std::span<const Vec3> one, std::span<const Vec3> other) {
  const RigidMotion motion = superposition(one, other);
  double sum = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i) sum += norm_squared(motion(one[i]) - other[i]);
  return std::sqrt(sum / double(one.size()));
}

double expected_of(double softness) {
  return softness > 0.0 ? exact_bits_exp(at_softness_1 + a_softness * exact_bits_log(softness))
                        : exact_bits_exp(at_softness_1);
}

double openness_of(double gyration, double nodes) {
  const double length = gyration / exact_bits_exp(exact_bits_log(nodes) / 3.0);
  const double e = exact_bits_exp(2.0 * (length - half_open) / open_width);
  return std::isfinite(e) ? (e - 1.0) / (e + 1.0) : 1.0;  // the hyperbolic tangent
}

}  // namespace

PlausibleShapes::PlausibleShapes(std::span<const Vec3> start, double scale)
    : start_(start.begin(), start.end()),
      softness_(pliant::softness(start, scale)),
      expected_(expected_of(softness_)),
      gyration_(gyration_of(start)),
      openness_(openness_of(gyration_, double(start.size()) * scale * scale * scale)) {}

double PlausibleShapes::score(std::span<const Vec3> shape) const {
  constexpr double least = 0.01;  // Angstrom
  const double apart = std::max(distance_of(start_, shape), least);
  const double off = exact_bits_log(apart / expected_);
  const double wider = gyration_of(shape) / gyration_ - 1.0;
  return -of_distance * off * off - of_gyration * wider * openness_;
}

}  // namespace pliant
