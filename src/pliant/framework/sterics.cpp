// SPDX-License-Identifier: MIT
#include "pliant/framework/sterics.hpp"

#include <algorithm>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

constexpr double furthest = 1e5;  // as far as a cell list reaches

void check_column(std::size_t size, std::size_t joint_count, const char* what) {
  if (size != joint_count)
    throw InputError("sterics: " + std::to_string(joint_count) + " joints but " +
                     std::to_string(size) + " " + what);
}

void check_distance(double least, const std::string& of) {
  if (!(least >= 0.0 && least <= furthest))
    throw InputError("sterics: least distance of " + of + " is " + number_text(least) +
                     ": must be from 0 to 1e5 Angstrom");
}

void check_table(const Sterics& sterics) {
  const std::size_t count = sterics.kind_count;
  if (sterics.least.size() != count * count)
    throw InputError("sterics: " + std::to_string(count) + " kinds but " +
                     std::to_string(sterics.least.size()) + " least distances");
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      const std::string pair = "kinds " + std::to_string(i) + " and " + std::to_string(j);
      check_distance(sterics.least[i * count + j], pair);
      if (sterics.least[i * count + j] != sterics.least[j * count + i])
        throw InputError("sterics: " + pair + " have two least distances, " +
                         number_text(sterics.least[i * count + j]) + " and " +
                         number_text(sterics.least[j * count + i]) + " Angstrom");
    }
  for (std::size_t i = 0; i < sterics.kinds.size(); ++i)
    if (sterics.kinds[i] >= count)
      throw InputError("sterics: joint " + std::to_string(i) + " is of kind " +
                       std::to_string(sterics.kinds[i]) + " of " + std::to_string(count));
}

std::string pair_text(std::uint32_t a, std::uint32_t b) {
  return "joints " + std::to_string(a) + " and " + std::to_string(b);
}

void check_pair(std::uint32_t a, std::uint32_t b, std::size_t joint_count) {
  if (a >= joint_count || b >= joint_count)
    throw InputError("sterics: " + pair_text(a, b) + " but there are " +
                     std::to_string(joint_count) + " joints");
  if (a == b) throw InputError("sterics: joint " + std::to_string(a) + " is paired with itself");
}

void check_own(const Sterics& sterics, std::size_t joint_count) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const OwnDistance& own : sterics.own) {
    check_pair(own.a, own.b, joint_count);
    check_distance(own.least, pair_text(own.a, own.b));
    pairs.push_back(std::minmax(own.a, own.b));
  }
  std::sort(pairs.begin(), pairs.end());
  const auto twice = std::adjacent_find(pairs.begin(), pairs.end());
  if (twice != pairs.end())
    throw InputError("sterics: " + pair_text(twice->first, twice->second) +
                     " have two distances of their own");
}

}  // namespace

double Sterics::largest() const {
  double most = 0.0;
  for (double distance : least) most = std::max(most, distance);
  for (const OwnDistance& pair : own) most = std::max(most, pair.least);
  return most;
}

void check(const Sterics& sterics, std::size_t joint_count) {
  check_column(sterics.kinds.size(), joint_count, "kinds");
  if (!sterics.units.empty()) check_column(sterics.units.size(), joint_count, "units");
  check_table(sterics);
  check_own(sterics, joint_count);
  if (sterics.excluded_bonds < 0)
    throw InputError("sterics: excluded_bonds = " + std::to_string(sterics.excluded_bonds) +
                     ": must be from 0");
  for (const auto& [a, b] : sterics.bonds) check_pair(a, b, joint_count);
}

}  // namespace pliant
