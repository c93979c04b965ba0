// SPDX-License-Identifier: MIT
#include "pliant/perturb/guide.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

void check_rock(const std::vector<Vec3>& field, const Framework& framework) {
  if (field.empty()) return;
  if (field.size() != framework.joint_count())
    throw OptionError("rock: " + std::to_string(field.size()) + " vectors for " +
                      std::to_string(framework.joint_count()) + " joints");
  for (std::size_t i = 0; i < field.size(); ++i)
    if (!is_finite(field[i]))
      throw OptionError("rock: the vector of " + framework.label(static_cast<Joint>(i)) +
                        " is not finite");
}

void check_group(const std::string& name, const std::vector<Joint>& group,
                 const Framework& framework) {
  if (group.empty()) throw OptionError(name + ": a group has no joint");
  for (Joint joint : group)
    if (joint >= framework.joint_count())
      throw OptionError(name + ": joint " + std::to_string(joint) + " of " +
                        std::to_string(framework.joint_count()) + " does not exist");
}

Vec3 centre_of(const std::vector<Joint>& group, std::span<const Vec3> positions) {
  Vec3 centre;
  for (Joint joint : group) centre += positions[joint];
  return (1.0 / double(group.size())) * centre;
}

}  // namespace

void check(const Guide& guide, const Framework& framework) {
  check_rock(guide.rock, framework);
  if (guide.period < 2)
    throw OptionError("period = " + std::to_string(guide.period) + ": must be 2 or more");
  for (const Pull& pull : guide.pulls) {
    check_group("pull", pull.joints, framework);
    if (!is_finite(pull.to)) throw OptionError("pull: where to is not finite");
  }
  for (const PairDistance& pair : guide.pairs) {
    check_group("pair distance", pair.first, framework);
    check_group("pair distance", pair.second, framework);
    const bool is_interval =
        pair.least >= 0.0 && pair.least <= pair.most && std::isfinite(pair.most);
    if (!is_interval)
      throw OptionError("pair distance: expected a distance from 0, or two in order, found " +
                        number_text(pair.least) + " to " + number_text(pair.most));
  }
}

std::vector<std::string> pushers_of(const Guide& guide) {
  std::vector<std::string> names;
  if (!guide.rock.empty()) names.push_back("rock");
  if (!guide.pulls.empty()) names.push_back("pull");
  if (!guide.pairs.empty()) names.push_back("pair_distance");
  return names;
}

bool has_arrived(const Guide& guide, std::span<const Vec3> positions) {
  if (guide.empty() || !guide.rock.empty()) return false;
  const auto is_at = [&](const Pull& pull) { return norm(way_of(pull, positions)) <= guide_slack; };
  const auto is_apart = [&](const PairDistance& pair) {
    return std::abs(excess_of(pair, positions)) <= guide_slack;
  };
  return std::all_of(guide.pulls.begin(), guide.pulls.end(), is_at) &&
         std::all_of(guide.pairs.begin(), guide.pairs.end(), is_apart);
}

Vec3 way_of(const Pull& pull, std::span<const Vec3> positions) {
  return pull.to - centre_of(pull.joints, positions);
}

Vec3 line_of(const PairDistance& pair, std::span<const Vec3> positions) {
  return centre_of(pair.second, positions) - centre_of(pair.first, positions);
}

double excess_of(const PairDistance& pair, std::span<const Vec3> positions) {
  const double now = norm(line_of(pair, positions));
  if (now > pair.most) return now - pair.most;
  return now < pair.least ? now - pair.least : 0.0;
}

}  // namespace pliant
