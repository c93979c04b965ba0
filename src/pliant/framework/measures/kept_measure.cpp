// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/kept_measure.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {

KeptMeasure::KeptMeasure(const Framework& framework, const Tolerance& tolerance)
    : framework_(framework), tolerance_(tolerance), squares_(framework.bar_count()) {
  bars_.assign(framework.bars());
  limits_.assign(std::span<const Limit>(framework.limits()));
  bar_parts_.resize(bars_.size());
  limit_parts_.resize(limits_.size());
  sums_.assign(bars_.size() + 1, 0.0);
  if (framework.sterics() != nullptr) neighbours_ = std::make_unique<NeighbourList>(framework);
}

ResidualSummary KeptMeasure::measure(std::span<const Vec3> positions, LimitsOff off) {
  ResidualSummary summary = measure_bars_and_limits(positions, off);
  if (!summary.finite || !neighbours_) return summary;
  if (!renew_overlaps(positions)) {
    summary.finite = summary.within = false;
    return summary;
  }
  take_overlaps(summary);
  return summary;
}

ResidualSummary KeptMeasure::measure_bars_and_limits(std::span<const Vec3> positions,
                                                     LimitsOff off) {
  look(positions);
  renew_bars(positions);
  renew_limits(positions, off);
  ResidualSummary summary;
  // What is not finite is rare: measure() stops at the first, and says which.
  if (!take_bars(summary) || !take_limits(summary))
    return pliant::measure(framework_, positions, tolerance_, off, neighbours_.get());
  if (framework_.bar_count() > 0)
    summary.rms_relative = std::min(std::sqrt(sum_of_squares() / double(framework_.bar_count())),
                                    summary.max_relative);
  return summary;
}

void KeptMeasure::look(std::span<const Vec3> positions) {
  if (!moved_.look(positions)) return;
  has_moved_ = true;
  bars_.note(moved_);
  limits_.note(moved_);
  overlaps_.note(moved_);
}

void KeptMeasure::renew_bars(std::span<const Vec3> positions) {
  bars_.look_at_stale([&](std::size_t group) {
    bar_parts_[group] = part_of_bars(positions, group);
    right_sums_ = std::min(right_sums_, group);
    visits_ += static_cast<std::int64_t>(bars_.last(group) - bars_.first(group));
  });
}

void KeptMeasure::renew_limits(std::span<const Vec3> positions, LimitsOff off) {
  if (!std::equal(off.begin(), off.end(), off_.begin(), off_.end())) {
    off_.assign(off.begin(), off.end());
    limits_.make_all_stale();
  }
  limits_.look_at_stale([&](std::size_t group) {
    limit_parts_[group] = part_of_limits(positions, group);
    visits_ += static_cast<std::int64_t>(limits_.last(group) - limits_.first(group));
  });
}

/// Returns false if positions cannot be listed.
bool KeptMeasure::renew_overlaps(std::span<const Vec3> positions) {
  if (has_moved_ && !neighbours_->update(positions)) return false;
  has_moved_ = false;
  if (lists_made_ != neighbours_->lists_made()) {
    lists_made_ = neighbours_->lists_made();
    overlaps_.assign(neighbours_->near());
    overlap_parts_.resize(overlaps_.size());
  }
  overlaps_.look_at_stale([&](std::size_t group) {
    overlap_parts_[group] = part_of_overlaps(positions, group);
    visits_ += static_cast<std::int64_t>(overlaps_.last(group) - overlaps_.first(group));
  });
  return true;
}

KeptMeasure::Part KeptMeasure::part_of_bars(std::span<const Vec3> positions, std::size_t group) {
  Part part;
  const auto bars = framework_.bars();
  const auto rests = framework_.rest_lengths();
  for (std::size_t k = bars_.first(group); k < bars_.last(group); ++k) {
    const double error = std::abs(residual(positions[bars[k].a], positions[bars[k].b], rests[k]));
    const double relative = error / rests[k];
    squares_[k] = relative * relative;
    if (!(error <= tolerance_.of(rests[k]))) part.within = false;
    if (!std::isfinite(error)) part.finite = false;
    if (error > part.most_length) part.most_length = error;
    part.take(relative, k);
  }
  return part;
}

KeptMeasure::Part KeptMeasure::part_of_limits(std::span<const Vec3> positions,
                                              std::size_t group) const {
  Part part;
  const auto limits = framework_.limits();
  for (std::size_t k = limits_.first(group); k < limits_.last(group); ++k) {
    const Limit& limit = limits[k];
    if (is_off(off_, static_cast<LimitIndex>(k))) continue;
    const double length = distance(positions[limit.a], positions[limit.b]);
    const double outside = std::abs(excess(limit, length));
    if (!std::isfinite(length)) part.finite = false;
    if (!(outside <= tolerance_.limit)) part.within = false;
    part.take(outside, k);
  }
  return part;
}

KeptMeasure::Part KeptMeasure::part_of_overlaps(std::span<const Vec3> positions,
                                                std::size_t group) const {
  Part part;
  const auto near = neighbours_->near();
  for (std::size_t k = overlaps_.first(group); k < overlaps_.last(group); ++k) {
    const double overlap = near[k].least - distance(positions[near[k].a], positions[near[k].b]);
    if (overlap > tolerance_.overlap) part.within = false;
    part.take(overlap, k);
  }
  return part;
}

/// Returns false if a length is not finite.
bool KeptMeasure::take_bars(ResidualSummary& summary) const {
  for (const Part& part : bar_parts_) {
    if (!part.finite) return false;
    summary.within = summary.within && part.within;
    summary.max_length = std::max(summary.max_length, part.most_length);
    if (!(part.most > summary.max_relative)) continue;
    summary.max_relative = part.most;
    summary.worst_bar = part.worst;
  }
  return true;
}

bool KeptMeasure::take_limits(ResidualSummary& summary) const {
  for (const Part& part : limit_parts_) {
    if (!part.finite) return false;
    summary.within = summary.within && part.within;
    if (!(part.most > summary.max_limit)) continue;
    summary.max_limit = part.most;
    summary.worst_limit = part.worst;
  }
  return true;
}

void KeptMeasure::take_overlaps(ResidualSummary& summary) const {
  for (const Part& part : overlap_parts_) {
    summary.within = summary.within && part.within;
    if (!(part.most > summary.max_overlap)) continue;
    const NeighbourPair& pair = neighbours_->near()[part.worst];
    summary.max_overlap = part.most;
    summary.worst_overlap = {pair.a, pair.b};
  }
}

/// Adds squares one after the other, in the order of the bars, as measure() does, from the first
/// group on that was measured anew.
double KeptMeasure::sum_of_squares() {
  double sum = sums_[right_sums_];
  for (std::size_t group = right_sums_; group < bars_.size(); ++group) {
    for (std::size_t k = bars_.first(group); k < bars_.last(group); ++k) sum += squares_[k];
    sums_[group + 1] = sum;
  }
  right_sums_ = bars_.size();
  return sum;
}

}  // namespace pliant
