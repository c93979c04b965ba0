// SPDX-License-Identifier: MIT
#include "pliant/resolve/units/unit_loop.hpp"

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

/// Newton's method and sweeps may stall at one start and not at another: one ring in a million does,
/// and would leave all of a large framework to them.
constexpr int most_attempts = 6;
constexpr double shake = 0.1;  // Angstrom

ResolveOptions half_the_tolerance(ResolveOptions options) {
  options.tolerance.relative *= 0.5;
  options.tolerance.length *= 0.5;
  return options;
}

}  // namespace

UnitLoop::UnitLoop(const Framework& framework, std::span<const Joint> joints,
                   std::span<const BarIndex> bars, const Technique& technique,
                   const ResolveOptions& options)
    : joints_(joints.begin(), joints.end()),
      part_(part_of(framework, joints, bars)),
      blocks_(make_blocks(part_, technique, half_the_tolerance(options))),
      positions_(joints.size()) {
  widest_gap_ = HUGE_VAL;
  for (double rest : part_.rest_lengths())
    widest_gap_ = std::min(widest_gap_, 0.2 * options.tolerance.of(rest));
}

void UnitLoop::close_by_torsions(UnitSet rigid, const UnitShapes& shapes) {
  const auto is_unknown = [](ShapeKind kind) { return kind == ShapeKind::unknown; };
  if (std::any_of(shapes.kinds.begin(), shapes.kinds.end(), is_unknown)) return;
  if (part_.has_pinned_joints()) return;
  for (Joint& joint : rigid.things()) joint = place_of(joints_, joint);
  closure_ = LoopClosure::make(rigid, shapes, connect_units(part_, rigid));
}

bool UnitLoop::find_shape(const ResolveCall& call) {
  for (int attempt = 0; attempt < most_attempts; ++attempt)
    if (find_shape_from(call, attempt * shake)) return true;
  return false;
}

/// Where the joints are, or each moved by `size` in a direction that the seed decides.
bool UnitLoop::find_shape_from(const ResolveCall& call, double size) {
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    positions_[k] = call.positions[joints_[k]];
    if (size == 0.0 || part_.is_pinned(static_cast<Joint>(k))) continue;
    RandomKey key = call.key;
    key.domain = Domain::escape;
    key.joint = joints_[k];
    positions_[k] += size * part_.random_direction(RandomSequence(key));
  }
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
