// SPDX-License-Identifier: MIT
#include "pliant/framework/joint_names.hpp"

#include "pliant/base/number.hpp"
#include "pliant/base/words.hpp"

namespace pliant {

JointNames::JointNames(const Framework& framework) : framework_(framework) {
  if (!framework.atoms()) return;
  const auto& names = framework.atoms()->names;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto [at, is_new] = joints_.emplace(names[i], static_cast<Joint>(i));
    if (!is_new) ++repeats_[names[i]];
  }
}

Joint JointNames::find(std::string_view word, const Place& place) const {
  if (repeats_.contains(word))
    fail(place, "joint: " + quoted(word) + " is the name of " +
                    std::to_string(repeats_.at(word) + 1) + " joints, use an index from 0");
  if (const auto at = joints_.find(word); at != joints_.end()) return at->second;
  const auto index = parse_integer(word);
  if (index && *index >= 0 && static_cast<std::size_t>(*index) < framework_.joint_count())
    return static_cast<Joint>(*index);
  fail(place, "joint: no joint is named " + quoted(word));
}

std::string JointNames::word_for(Joint joint, std::string_view file) const {
  if (framework_.atoms()) {
    const std::string& name = framework_.atoms()->names[joint];
    if (!repeats_.contains(name) && is_word(name)) return name;
  }
  std::string index = std::to_string(joint);
  if (joints_.contains(index))
    throw InputError(std::string(file) + ": " + framework_.label(joint) +
                     " has no name of its own, and its index " + index +
                     " is the name of another joint");
  return index;
}

}  // namespace pliant
