// SPDX-License-Identifier: MIT
// What became of the guide of a run.
#pragma once

#include <span>

#include "output/json.hpp"
#include "pliant/jobs/asked/guide_asked.hpp"

namespace pliant::app {

/// Distances of pairs at the start, at the end and as asked, and how far pulled groups are from
/// their targets.
class GuideEnd {
 public:
  /// Positions (N) of the first and the last frame. All arguments must outlive it.
  GuideEnd(const GuideAsked& settings, const Guide& guide, std::span<const Vec3> first,
           std::span<const Vec3> last)
      : settings_(settings), guide_(guide), first_(first), last_(last) {}

  bool is_reached() const;
  void print() const;
  Json json() const;

 private:
  bool is_there(const PairDistance& pair) const;
  bool is_there(const Pull& pull) const;

  const GuideAsked& settings_;
  const Guide& guide_;
  std::span<const Vec3> first_, last_;
};

}  // namespace pliant::app
