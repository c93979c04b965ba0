// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/near_pass.hpp"

#include <cmath>

#include "pliant/framework/measures/residual.hpp"
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
      is_entered_(blocks.count(), 0) {}

/// A pass from one joint leaves no bar broken but at the disturbed joints whose turn is to come.
bool NearPass::run(const ResolveCall& call, ResolveSummary& summary) {
  if (!run_from(call.disturbed.root, call, summary)) return false;
  for (Joint joint : call.disturbed.joints)
    if (joint != call.disturbed.root && !run_from(joint, call, summary)) return false;
  if (!call.moved->joints().empty()) ++summary.sweeps;
  return true;
}

/// What the push reaches are the joint and those that move. Bridges and blocks hang together as a
/// tree: no joint is reached twice, and over no bridge the joint from which it was reached.
bool NearPass::run_from(Joint joint, const ResolveCall& call, ResolveSummary& summary) {
  for (std::uint32_t block : entered_) is_entered_[block] = 0;
  entered_.clear();
  reached_.assign(1, {joint, no_bar});
  for (std::size_t k = 0; k < reached_.size(); ++k)
    if (!take(reached_[k], call, summary)) return false;
  return true;
}

bool NearPass::take(Reached reached, const ResolveCall& call, ResolveSummary& summary) {
  for (const Incidence& at : framework_.neighbours(reached.joint)) {
    const std::uint32_t block = planner_.block_of(at.bar);
    if (block != no_block) {
      if (!is_entered_[block] && !solve(block, reached.joint, call, summary)) return false;
    } else if (at.bar != reached.over) {
      ++summary.projections;
      project(reached.joint, at, call);
    }
  }
  return true;
}

void NearPass::project(Joint near, const Incidence& at, const ResolveCall& call) {
  const double rest = framework_.rest_lengths()[at.bar];
  Vec3 &x_near = call.positions[near], &x_far = call.positions[at.joint];
  if (std::abs(residual(x_near, x_far, rest)) <= tolerance_.of(rest)) return;
  call.moved->note(at.joint, x_far);
  reached_.push_back({at.joint, at.bar});
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
    if (call.positions[joint] == before) return;
    call.moved->note(joint, before);
    reached_.push_back({joint, no_bar});
  });
  return whole;
}

}  // namespace pliant
