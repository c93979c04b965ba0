// SPDX-License-Identifier: MIT
// Resolves what a push of few joints has broken within the region around them: its rigid units are
// pulled by their torsions to where the push left their joints, and pushed apart until limits and
// sterics hold, while the joints that the region shares with the rest stay where they are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/measures/residual.hpp"
#include "pliant/resolve/bodies/region/local_contacts.hpp"
#include "pliant/resolve/bodies/region/region_planner.hpp"
#include "pliant/resolve/bodies/tree/articulated_step.hpp"
#include "pliant/resolve/bodies/tree/working_trees.hpp"

namespace pliant {

struct LocalOptions {
  /// How many times as strongly as any other joint the pushed ones are pulled.
  double weight = 1.0;
  double goal = 0.02;  ///< Angstrom: contacts are repaired until they are broken by no more
  double unit = 1.0;   ///< Angstrom: unit of lengths that bound and damp steps, 1 for molecules
};

/// What is pushed. All must outlive the call.
struct LocalPush {
  std::span<const Vec3> start;    ///< (N, Angstrom) positions at which all is whole
  std::span<const Vec3> target;   ///< (N) the same, but for the pushed joints
  std::span<const Joint> joints;  ///< the pushed joints, not empty
  std::uint64_t step = 0;         ///< units get back their drawn shapes at one in eight
  LimitsOff limits_off = {};
  JointNeighbours* neighbours = nullptr;  ///< null: no sterics
};

struct LocalResult {
  bool is_whole = false;  ///< the region hangs on the rest as before, and contacts hold
  /// The share of the push that the pushed joints have followed.
  double followed = 0.0;
  std::int64_t visits = 0;  ///< bodies visited, over all steps
};

/// Not thread-safe.
class LocalSolver {
 public:
  /// The framework must outlive it.
  LocalSolver(const Framework& framework, const Tolerance& tolerance, const LocalOptions& options);

  /// Resolves in a region of at most some `most_bodies`. The new positions are visited by
  /// visit_moved(); bars keep the lengths that they have at the start, to rounding.
  LocalResult resolve(const LocalPush& push, std::size_t most_bodies);
  /// Whether units form loops, which are rigid only if the framework is drawn.
  bool has_loops() const { return planner_.has_loops(); }
  /// Whether the last region was all that is connected with what was pushed.
  bool was_free() const { return plan_->cuts().empty() && !plan_->is_ground(0); }

  /// Calls visit(joint, its new position) for each joint of the region that may have moved.
  template <class Visit>
  void visit_moved(const Visit& visit) const;

 private:
  void begin(const LocalPush& push, std::size_t most_bodies);
  void pull();
  double pull_blindly();
  void set_targets(double share);
  void repair();
  bool close();
  double followed() const;
  bool is_near() const;
  double step(const StepRequest& request);

  RegionPlanner planner_;
  DrawnShapes shapes_;
  const BodyPlan* plan_;
  WorkingTrees working_;
  ArticulatedStep step_;
  LocalContacts contacts_;
  Tolerance tolerance_;
  LocalOptions options_;
  bool has_contacts_;
  Vec3 origin_;
  double way_ = 0.0;  ///< longest push (Angstrom)
  int legs_ = 1;
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
