// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/outward/unit_loop.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/resolve/blocks/blocks.hpp"

namespace pliant {
namespace {

Joint place_of(std::span<const Joint> joints, Joint joint) {
  return static_cast<Joint>(std::lower_bound(joints.begin(), joints.end(), joint) - joints.begin());
}

Framework part_of(const Framework& framework, std::span<const Joint> joints,
                  std::span<const BarIndex> bars) {
  FrameworkParts parts;
  parts.joint_count = joints.size();
  for (BarIndex k : bars) {
    const Bar bar = framework.bars()[k];
    parts.bars.push_back({place_of(joints, bar.a), place_of(joints, bar.b)});
    parts.rest_lengths.push_back(framework.rest_lengths()[k]);
  }
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const double inverse_mass = framework.inverse_masses()[joints[k]];
    parts.masses.push_back(inverse_mass > 0.0 ? 1.0 / inverse_mass : 1.0);
    if (inverse_mass == 0.0) parts.pinned.push_back(static_cast<Joint>(k));
  }
  return Framework(std::move(parts));
}

/// Newton's method and sweeps may stall at one start and not at another: one ring in a million
/// does, and would leave all of a large framework to them.
constexpr int most_attempts = 6;
constexpr double shake = 0.1;  // of the shortest bar

/// Shares of a push that a loop tries to follow where it cannot follow all of it.
constexpr double shares[] = {0.5, 0.25};

/// Angles that Newton's method does not make whole are hardly made so by sweeps.
constexpr std::int64_t most_loop_sweeps = 200;

ResolveOptions half_the_tolerance(ResolveOptions options) {
  options.tolerance.relative *= 0.5;
  options.tolerance.length *= 0.5;
  options.max_sweeps = std::min(options.max_sweeps, most_loop_sweeps);
  return options;
}

}  // namespace

UnitLoop::UnitLoop(const Framework& framework, std::span<const Joint> joints,
                   std::span<const BarIndex> bars, const Technique& technique,
                   const ResolveOptions& options)
    : joints_(joints.begin(), joints.end()),
      part_(part_of(framework, joints, bars)),
      tolerance_(options.tolerance),
      blocks_(make_blocks(part_, technique, half_the_tolerance(options))),
      positions_(joints.size()) {
  shortest_ = widest_gap_ = HUGE_VAL;
  for (double rest : part_.rest_lengths()) {
    shortest_ = std::min(shortest_, rest);
    widest_gap_ = std::min(widest_gap_, 0.2 * options.tolerance.of(rest));
  }
}

void UnitLoop::close_by_torsions(UnitSet rigid, const UnitShapes& shapes) {
  const auto is_unknown = [](ShapeKind kind) { return kind == ShapeKind::unknown; };
  if (std::any_of(shapes.kinds.begin(), shapes.kinds.end(), is_unknown)) return;
  if (part_.has_pinned_joints()) return;
  for (Joint& joint : rigid.things()) joint = place_of(joints_, joint);
  closure_ = LoopClosure::make(rigid, shapes, connect_units(part_, rigid));
}

bool UnitLoop::find_shape(const ResolveCall& call) {
  take(call.positions);
  if (make_whole(call)) return true;
  if (!call.reference.empty() && go_part_of_the_way(call)) return true;
  for (int attempt = 1; attempt < most_attempts; ++attempt) {
    take(call.positions);
    shake_by(attempt * shake * shortest_, call.key);
    if (make_whole(call)) return true;
  }
  return false;
}

/// Goes from where the loop was whole before the push, less and less far; at last it keeps that
/// shape.
bool UnitLoop::go_part_of_the_way(const ResolveCall& call) {
  for (double share : shares) {
    take(call.reference);
    for (std::size_t k = 0; k < joints_.size(); ++k)
      positions_[k] += share * (call.positions[joints_[k]] - positions_[k]);
    if (make_whole(call)) return true;
  }
  take(call.reference);
  if (closure_) closure_->close(positions_, widest_gap_);
  return is_whole(part_, positions_, tolerance_);
}

void UnitLoop::take(std::span<const Vec3> positions) {
  for (std::size_t k = 0; k < joints_.size(); ++k) positions_[k] = positions[joints_[k]];
}

/// Moves each joint in a direction that the key decides.
void UnitLoop::shake_by(double size, RandomKey key) {
  key.domain = Domain::escape;
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    if (part_.is_pinned(static_cast<Joint>(k))) continue;
    key.joint = joints_[k];
    positions_[k] += size * part_.random_direction(RandomSequence(key));
  }
}

bool UnitLoop::make_whole(const ResolveCall& call) {
  ResolveCall alone = call;
  alone.positions = positions_;
  alone.disturbed = {};
  alone.moved = nullptr;
  alone.reference = {};
  if (closure_) closure_->close(positions_, widest_gap_);
  ResolveSummary summary;
  summary.sweeps = summary.projections = 0;
  return blocks_->resolve(alone, summary) == Stop::converged;
}

}  // namespace pliant
