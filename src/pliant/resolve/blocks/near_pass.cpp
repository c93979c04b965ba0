// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/near_pass.hpp"

#include <cmath>

#include "pliant/framework/residual.hpp"
#include "pliant/resolve/method/project_bar.hpp"

namespace pliant {
namespace {

/// In large frameworks most of a step is waiting for memory: asks for what is looked at next.
void fetch_early([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
  __builtin_prefetch(address);
#endif
}

}  // namespace

NearPass::NearPass(const Framework& framework, const OutwardPlanner& planner, BlockSolver& blocks,
                   const Tolerance& tolerance)
    : framework_(framework),
      planner_(planner),
      blocks_(blocks),
      tolerance_(tolerance),
      moved_(framework.joint_count()),
      is_entered_(blocks.count(), 0) {}

void NearPass::clear() {
  moved_.clear();
  for (std::uint32_t block : entered_) is_entered_[block] = 0;
  entered_.clear();
}

/// What the push reaches are the root and the joints that move.
bool NearPass::run(const ResolveCall& call, ResolveSummary& summary) {
  clear();
  if (!take(call.root, call, summary)) return false;
  for (std::size_t k = 0; k < moved_.joints().size(); ++k) {
    const Joint joint = moved_.joints()[k];
    if (joint != call.root && !take(joint, call, summary)) return false;
  }
  if (!moved_.joints().empty()) ++summary.sweeps;
  return true;
}

bool NearPass::take(Joint joint, const ResolveCall& call, ResolveSummary& summary) {
  for (const Incidence& at : framework_.neighbours(joint)) {
    const std::uint32_t block = planner_.block_of(at.bar);
    if (block != no_block) {
      if (!is_entered_[block] && !solve(block, joint, call, summary)) return false;
    } else if (at.joint != call.root && !moved_.holds(at.joint)) {
      ++summary.projections;
      project(joint, at, call);
    }
  }
  return true;
}

void NearPass::project(Joint near, const Incidence& at, const ResolveCall& call) {
  const double rest = framework_.rest_lengths()[at.bar];
  Vec3 &x_near = call.positions[near], &x_far = call.positions[at.joint];
  if (std::abs(residual(x_near, x_far, rest)) <= tolerance_.of(rest)) return;
  moved_.note(at.joint, x_far);
  fetch_early(framework_.neighbours(at.joint).data());
  carry_far(x_near, x_far, rest,
            [&] { return escape_direction(call.key, at.bar, framework_.is_planar()); });
}

bool NearPass::solve(std::uint32_t block, Joint entry, const ResolveCall& call,
                     ResolveSummary& summary) {
  is_entered_[block] = 1;
  entered_.push_back(block);
  before_.clear();
  blocks_.each_joint(block, [&](Joint joint) { before_.push_back(call.positions[joint]); });
  const bool whole = blocks_.solve(block, entry, call.key, call.positions, summary);
  std::size_t k = 0;
  blocks_.each_joint(block, [&](Joint joint) {
    const Vec3 before = before_[k++];
    if (!(call.positions[joint] == before)) moved_.note(joint, before);
  });
  return whole;
}

}  // namespace pliant
