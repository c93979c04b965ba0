// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/check_positions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

// The square of a distance beyond this overflows a double.
constexpr double furthest_coordinate = 1e150;

double largest_coordinate(const Framework& framework, std::span<const Vec3> positions) {
  double largest = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 x = positions[i];
    if (!is_finite(x))
      throw InputError("position of " + framework.label(static_cast<Joint>(i)) + " is not finite");
    largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  }
  return largest;
}

std::string short_number(double value) { return number_text(value, 2); }

}  // namespace

void check_positions(const Framework& framework, std::span<const Vec3> positions,
                     const Tolerance& tolerance, const Log& log) {
  if (positions.size() != framework.joint_count())
    throw InputError("framework: " + std::to_string(framework.joint_count()) + " joints but " +
                     std::to_string(positions.size()) + " positions");
  const double largest = largest_coordinate(framework, positions);
  const auto rests = framework.rest_lengths();
  if (rests.empty()) return;
  if (largest > furthest_coordinate)
    throw InputError("coordinates reach " + short_number(largest) +
                     " Angstrom: must be within 1e150 of the origin");
  const double spacing = largest * std::numeric_limits<double>::epsilon();
  const auto shortest = std::min_element(rests.begin(), rests.end());
  const std::string bar = framework.label(framework.bars()[std::size_t(shortest - rests.begin())]);
  if (spacing >= *shortest)
    throw InputError("coordinates reach " + short_number(largest) +
                     " Angstrom, where doubles are " + short_number(spacing) +
                     " apart: too coarse for bar " + bar + "; move the molecule to the origin");
  if (spacing > tolerance.of(*shortest))
    log.warn("coordinates reach " + short_number(largest) + " Angstrom, where doubles are " +
             short_number(spacing) + " apart: the tolerance of bar " + bar + " cannot be met");
}

}  // namespace pliant
