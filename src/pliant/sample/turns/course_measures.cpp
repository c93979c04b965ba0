// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/course_measures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant {
namespace {

constexpr double most_stretch = 1.0;  // Angstrom outside of an interval
constexpr int measured_shares = 8;    // of a course, for its length

}  // namespace

Course course_of(const NetworkNodes& nodes, std::span<const std::uint32_t> of_joint,
                 const DrawnTurns& turned, std::vector<Vec3> from, std::vector<Vec3> moves) {
  Course course;
  course.at = [of_joint, turned, turning = TurnCourse(nodes, *turned.tree), from,
               moves = std::move(moves)](double share, std::span<Vec3> out) mutable {
    const auto motions = turning.motions(turned.turns, share);
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = motions[of_joint[k]](from[k] + share * moves[k]);
  };
  course.length = length_of(course, from);
  return course;
}

double length_of(const Course& course, std::span<const Vec3> start) {
  std::vector<Vec3> before(start.begin(), start.end()), now(start.size());
  std::vector<double> ways(start.size(), 0.0);
  for (int k = 1; k <= measured_shares; ++k) {
    course.at(double(k) / measured_shares, now);
    for (std::size_t j = 0; j < now.size(); ++j) ways[j] += distance(before[j], now[j]);
    before.swap(now);
  }
  return *std::max_element(ways.begin(), ways.end());
}

std::vector<std::uint8_t> torn_limits(const Framework& framework, std::span<const Vec3> x) {
  const auto limits = framework.limits();
  std::vector<std::uint8_t> torn(limits.size(), 0);
  std::vector<std::uint32_t> gone;
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const double length = distance(x[limits[k].a], x[limits[k].b]);
    if (!(std::abs(excess(limits[k], length)) > most_stretch)) continue;
    torn[k] = 1;
    if (limits[k].group != no_limit_group) gone.push_back(limits[k].group);
  }
  std::sort(gone.begin(), gone.end());
  for (std::size_t k = 0; k < limits.size(); ++k)
    if (std::binary_search(gone.begin(), gone.end(), limits[k].group)) torn[k] = 1;
  return torn;
}

}  // namespace pliant
