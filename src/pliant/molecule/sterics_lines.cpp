// SPDX-License-Identifier: MIT
#include "pliant/molecule/sterics_lines.hpp"

#include <algorithm>
#include <limits>

#include "pliant/base/elements.hpp"

namespace pliant {

std::string_view usual_kind(const Framework& joints, Joint joint) {
  return element_symbol(joints.atoms() ? joints.atoms()->elements[joint] : std::uint8_t{0});
}

void StericsLines::add_least(std::string_view one, std::string_view other, double least,
                             const Place& place) {
  for (std::string_view name : {one, other})
    if (name == no_kind) fail(place, "sterics: joints of kind \"none\" touch nothing");
  const auto [low, high] = std::minmax(one, other);
  if (!least_.emplace(std::pair(std::string(low), std::string(high)), least).second)
    fail(place,
         "sterics: " + pliant::quoted(one) + " and " + pliant::quoted(other) + " are given twice");
  kinds_.emplace(one, std::uint16_t{0}), kinds_.emplace(other, std::uint16_t{0});
  if (kinds_.size() >= std::numeric_limits<std::uint16_t>::max())
    fail(place, "sterics: expected at most 65534 kinds");
  std::uint16_t number = 0;
  for (auto& [name, kind] : kinds_) kind = number++;
}

void StericsLines::add_kind(Joint joint, std::string_view name, const Place& place) {
  const auto [row, is_new] = stated_.emplace(joint, StatedKind{std::string(name), place.line});
  if (!is_new)
    fail(place, "kind: is given twice, first in line " + std::to_string(row->second.line));
}

void StericsLines::add_own(Joint a, Joint b, double least, const Place& place) {
  const auto [row, is_new] = own_lines_.emplace(std::minmax(a, b), place.line);
  if (!is_new) fail(place, "own: is given twice, first in line " + std::to_string(row->second));
  own_.push_back({a, b, least});
}

void StericsLines::add_bonds_apart(int bonds, const Place& place) {
  if (bonds_apart_) fail(place, "bonds_apart: is given twice");
  bonds_apart_ = bonds;
  bonds_apart_line_ = place.line;
}

void StericsLines::check_kinds(const Place& file) const {
  for (const auto& [joint, stated] : stated_)
    if (stated.name != no_kind && !kinds_.contains(stated.name))
      fail({file.file, stated.line}, "kind: no sterics line names " + pliant::quoted(stated.name));
  if (bonds_apart_ && least_.empty() && own_.empty())
    fail({file.file, bonds_apart_line_}, "bonds_apart: there is no sterics line");
}

NamedSterics StericsLines::table_of(const Framework& joints) const {
  NamedSterics found;
  for (const auto& row : kinds_) found.kind_names.push_back(row.first);
  found.kind_names.emplace_back();
  Sterics& sterics = found.sterics;
  const std::size_t count = sterics.kind_count = found.kind_names.size();
  sterics.least.assign(count * count, 0.0);
  for (const auto& [names, least] : least_) {
    const std::size_t i = kinds_.at(names.first), j = kinds_.at(names.second);
    sterics.least[i * count + j] = sterics.least[j * count + i] = least;
  }
  for (Joint joint = 0; joint < joints.joint_count(); ++joint) {
    const auto stated = stated_.find(joint);
    const auto kind = kinds_.find(stated != stated_.end() ? std::string_view(stated->second.name)
                                                          : usual_kind(joints, joint));
    sterics.kinds.push_back(kind != kinds_.end() ? kind->second
                                                 : static_cast<std::uint16_t>(count - 1));
  }
  return found;
}

std::optional<NamedSterics> StericsLines::put_together(const Framework& joints,
                                                       std::string_view file) const {
  check_kinds({file});
  if (least_.empty() && own_.empty()) return std::nullopt;
  NamedSterics found = table_of(joints);
  found.sterics.own = own_;
  if (bonds_apart_) found.sterics.excluded_bonds = *bonds_apart_;
  return found;
}

}  // namespace pliant
