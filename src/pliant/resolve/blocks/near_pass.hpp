// SPDX-License-Identifier: MIT
// The outward pass of `blocks` after a push of few joints: it ends where nothing has moved.
#pragma once

#include <vector>

#include "pliant/resolve/blocks/block_solver.hpp"
#include "pliant/resolve/blocks/outward_plan.hpp"
#include "pliant/resolve/method/method.hpp"
#include "pliant/resolve/method/moved_joints.hpp"

namespace pliant {

/// Breadth first from each disturbed joint over broken bars and blocks. Whole bars are left alone
/// and end the search. A bond behind which the chain bends passes on only a part of the push, so
/// that the region is small.
class NearPass {
 public:
  /// All three must outlive it.
  NearPass(const Framework& framework, const OutwardPlanner& planner, BlockSolver& blocks,
           const Tolerance& tolerance);

  /// Notes moved joints in call.moved. Returns false if a block could not be resolved.
  bool run(const ResolveCall& call, ResolveSummary& summary);

 private:
  static constexpr BarIndex no_bar = ~BarIndex{0};
  struct Reached {
    Joint joint;
    BarIndex over;  ///< the bridge over which it was reached, if any
  };

  bool run_from(Joint joint, const ResolveCall& call, ResolveSummary& summary);
  bool take(Reached reached, const ResolveCall& call, ResolveSummary& summary);
  void project(Joint near, const Incidence& at, const ResolveCall& call);
  bool solve(std::uint32_t block, Joint entry, const ResolveCall& call, ResolveSummary& summary);

  const Framework& framework_;
  const OutwardPlanner& planner_;
  BlockSolver& blocks_;
  Tolerance tolerance_;
  std::vector<Reached> reached_;          ///< in the pass from one joint
  std::vector<std::uint8_t> is_entered_;  ///< (blocks)
  std::vector<std::uint32_t> entered_;
  std::vector<Vec3> before_;  ///< of a block's joints, to find which ones moved
};

}  // namespace pliant
