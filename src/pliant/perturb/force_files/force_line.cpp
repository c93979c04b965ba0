// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_files/force_line.hpp"

#include <cmath>

#include "pliant/base/number.hpp"

namespace pliant {
namespace {

/// The square of a larger force overflows on its way to a length.
constexpr double largest_force = 1e100;

double component(const Words& words, std::size_t k, const Place& place) {
  const auto value = parse_real(words[k]);
  if (!value || std::abs(*value) > largest_force)
    fail(place, std::string("force ") + "xyz"[k - 2] +
                    ": expected a finite number up to 1e100, found " + quoted(words[k]));
  return *value;
}

}  // namespace

JointForce force_of(const Words& words, const JointNames& names, const Place& place) {
  if (words.size() != 5)
    fail(place, std::string(words[0]) + ": expected a joint and a force (x, y, z), found " +
                    std::to_string(words.size() - 1) + " fields");
  const Joint joint = names.find(words[1], place);
  return {joint,
          {component(words, 2, place), component(words, 3, place), component(words, 4, place)}};
}

std::string force_line(std::string_view word, const JointForce& force, const JointNames& names) {
  return std::string(word) + " " + names.word_for(force.joint, "force file") + " " +
         shortest_text(force.force.x) + " " + shortest_text(force.force.y) + " " +
         shortest_text(force.force.z) + "\n";
}

}  // namespace pliant
