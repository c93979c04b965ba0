// SPDX-License-Identifier: MIT
// Resolves what a push of few joints has broken within the region around them: its rigid units are
// pulled by their torsions to where the push left their joints, while the joints that the region
// shares with the rest stay where they are.
#pragma once

#include <span>
#include <vector>

#include "pliant/resolve/froda/bodies/articulated_step.hpp"
#include "pliant/resolve/froda/bodies/working_trees.hpp"
#include "pliant/resolve/local/region_planner.hpp"

namespace pliant {

struct LocalResult {
  bool is_closed = false;  ///< the region hangs on the rest as before, to rounding
  std::int64_t visits = 0;  ///< bodies visited, over all steps
};

/// Not thread-safe.
class LocalSolver {
 public:
  /// The framework must outlive it. `unit` (Angstrom) is the unit of lengths that bound and damp
  /// steps, 1 for molecules.
  explicit LocalSolver(const Framework& framework, double unit = 1.0);

  /// How many times as strongly as any other joint the pushed ones are pulled.
  void set_weight(double weight) { weight_ = weight; }

  /// `start` (N, Angstrom): positions with whole bars. `target` (N): the same, but for the pushed
  /// `joints`. The new positions are in places(); bars keep the lengths that they have at the
  /// start, to rounding.
  LocalResult resolve(std::span<const Vec3> start, std::span<const Vec3> target,
                      std::span<const Joint> joints);

  /// Calls visit(joint, its new position) for each joint of the region that may have moved.
  template <class Visit>
  void visit_moved(const Visit& visit) const;

 private:
  void begin(std::span<const Vec3> start, std::span<const Vec3> target,
             std::span<const Joint> joints);
  void pull();
  bool close();
  double widest_gap() const;
  double step(const StepRequest& request);

  RegionPlanner planner_;
  const BodyPlan* plan_ = nullptr;
  WorkingTrees working_;
  ArticulatedStep step_;
  double unit_;
  double weight_ = 1.0;
  Vec3 origin_;
  double way_ = 0.0;  ///< longest push (Angstrom)
  std::vector<Vec3> x_, start_, push_, target_;  ///< of places, from the origin
  std::vector<PlacePull> pulls_;                 ///< of pushed joints
  std::int64_t visits_ = 0;
};

template <class Visit>
void LocalSolver::visit_moved(const Visit& visit) const {
  const auto joint_at = plan_->joint_at();
  for (Slot place = 0; place < joint_at.size(); ++place) {
    const Joint joint = joint_at[place];
    if (plan_->place_of(joint) == place && !plan_->is_ground(plan_->body_at()[place]))
      visit(joint, x_[place] + origin_);
  }
}

}  // namespace pliant
