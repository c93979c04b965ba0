// SPDX-License-Identifier: MIT
// What of a Framework concerns limits and sterics.
#include <algorithm>
#include <cmath>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {
namespace {

constexpr double furthest_limit = 1e150;  // as of rest lengths

}  // namespace

void Framework::check_limits() const {
  if (limits_.size() > std::numeric_limits<LimitIndex>::max() / 2)
    throw InputError("framework: " + std::to_string(limits_.size()) +
                     " limits, but fewer than 2^31 can be held");
  for (std::size_t k = 0; k < limits_.size(); ++k) check_limit(k);
  if (sterics_) check(*sterics_, joint_count_);
}

void Framework::check_limit(std::size_t index) const {
  const Limit& limit = limits_[index];
  if (limit.a >= joint_count_ || limit.b >= joint_count_)
    throw InputError("limit " + std::to_string(index) + " joins joints " + std::to_string(limit.a) +
                     " and " + std::to_string(limit.b) + " but there are " +
                     std::to_string(joint_count_) + " joints");
  if (limit.a == limit.b)
    throw InputError("limit " + std::to_string(index) + " joins " + label(limit.a) + " to itself");
  const std::string pair = "limit " + label(Bar{limit.a, limit.b});
  if (!(limit.least >= 0.0 && limit.least <= furthest_limit))
    throw InputError(pair + " has least distance " + number_text(limit.least) +
                     ": must be from 0 to 1e150 Angstrom");
  if (!(limit.most > 0.0 && (limit.most <= furthest_limit || std::isinf(limit.most))))
    throw InputError(pair + " has most distance " + number_text(limit.most) +
                     ": must be above 0, up to 1e150 Angstrom or infinite");
  if (limit.least > limit.most)
    throw InputError(pair + " has least distance " + number_text(limit.least) + " above most " +
                     number_text(limit.most) + " Angstrom");
  if (!std::isfinite(limit.energy))
    throw InputError(pair + " has energy " + number_text(limit.energy) + ": must be finite");
  for (const Incidence& at : neighbours(limit.a))
    if (at.joint == limit.b)
      throw InputError(pair + " has a bar already, of " + number_text(rest_lengths_[at.bar]) +
                       " Angstrom");
}

void Framework::index_limits() {
  if (limits_.empty()) return;
  first_limit_.assign(joint_count_ + 1, 0);
  for (const Limit& limit : limits_) ++first_limit_[limit.a + 1], ++first_limit_[limit.b + 1];
  for (std::size_t i = 0; i < joint_count_; ++i) first_limit_[i + 1] += first_limit_[i];
  limits_at_.resize(2 * limits_.size());
  std::vector<std::uint32_t> next(first_limit_.begin(), first_limit_.end() - 1);
  for (LimitIndex k = 0; k < limits_.size(); ++k) {
    limits_at_[next[limits_[k].a]++] = k;
    limits_at_[next[limits_[k].b]++] = k;
  }
}

std::span<const LimitIndex> Framework::limits_at(Joint joint) const {
  if (limits_.empty()) return {};
  return {limits_at_.data() + first_limit_[joint], limits_at_.data() + first_limit_[joint + 1]};
}

}  // namespace pliant
