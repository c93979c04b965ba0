// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/near_measure.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {

bool NearMeasure::begin(std::span<const Vec3> positions, std::span<const Joint> joints,
                        bool continues) {
  if (framework_.sterics() == nullptr) return true;
  const bool is_new = !neighbours_;
  if (is_new) neighbours_ = std::make_unique<JointNeighbours>(framework_);
  if (is_new || !continues) return neighbours_->start(positions);
  look(positions, joints);
  return true;
}

void NearMeasure::look(std::span<const Vec3> positions, std::span<const Joint> joints) {
  if (!neighbours_) return;
  for (Joint joint : joints) neighbours_->look(joint, positions[joint]);
}

void NearMeasure::measure_contacts(std::span<const Vec3> positions, Joint joint, LimitsOff off,
                                   ResidualSummary& found) const {
  measure_limits(positions, joint, off, found);
  if (neighbours_) measure_overlaps(positions, joint, found);
}

void NearMeasure::measure_limits(std::span<const Vec3> positions, Joint joint, LimitsOff off,
                                 ResidualSummary& found) const {
  for (LimitIndex k : framework_.limits_at(joint)) {
    if (is_off(off, k)) continue;
    const Limit& limit = framework_.limits()[k];
    const double length = distance(positions[limit.a], positions[limit.b]);
    const double outside = std::abs(excess(limit, length));
    if (!std::isfinite(length)) found.finite = false;
    if (!(outside <= tolerance_.limit)) found.within = false;
    if (!(outside > found.max_limit)) continue;
    found.max_limit = outside;
    found.worst_limit = k;
  }
}

void NearMeasure::measure_overlaps(std::span<const Vec3> positions, Joint joint,
                                   ResidualSummary& found) const {
  for (const NearJoint& near : neighbours_->near(joint)) {
    const double overlap = near.least - distance(positions[joint], positions[near.joint]);
    if (overlap > tolerance_.overlap) found.within = false;
    if (!(overlap > found.max_overlap)) continue;
    found.max_overlap = overlap;
    found.worst_overlap = {std::min(joint, near.joint), std::max(joint, near.joint)};
  }
}

}  // namespace pliant
