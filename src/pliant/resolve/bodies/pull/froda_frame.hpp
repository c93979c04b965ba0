// SPDX-License-Identifier: MIT
// The state of one frame: positions of its joints, the targets of the push, the broken contacts,
// and the request for its next step. A FrodaSolver takes the steps of one frame, FrodaLanes those
// of eight at once.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/framework/course.hpp"
#include "pliant/framework/limits.hpp"
#include "pliant/resolve/bodies/near/near_pairs.hpp"
#include "pliant/resolve/bodies/tree/articulated_step.hpp"
#include "pliant/resolve/bodies/tree/working_trees.hpp"

namespace pliant {

/// What a frame begins with. All must outlive it.
struct FrodaPush {
  std::span<const Vec3> start;     ///< (N, Angstrom) whole positions
  std::span<const Vec3> target;    ///< (N) where the push wants the joints at its end
  LimitsOff limits_off = {};       ///< (L) or empty
  const Course* course = nullptr;  ///< null: straight lines from start to target
};

struct FrodaOptions {
  double limit = 0.08;    ///< Angstrom by which a limit may be outside its interval
  double overlap = 0.08;  ///< Angstrom by which two joints may be nearer than allowed
  /// Angstrom: steps end when both are below this, or when nothing more is gained.
  double goal = 0.02;
  /// Considers contacts at every step, with conjugate gradients in each: for pushes of several
  /// Angstrom, during which chains must not pass through each other.
  bool is_careful = false;
  int conjugate_gradients = 2;  ///< iterations of careful steps
  double leg = 2.0;             ///< Angstrom: largest distance between intermediate targets
  /// Careful pulls on the way consider contacts each time so many targets are passed.
  int legs_a_look = 1;
  double bound = 1.5;          ///< Angstrom: largest displacement of a body in such a step
  int last_steps = 60;         ///< number of steps for contacts alone
  double last_weight = 100.0;  ///< of contacts in these, against the inertia of a joint
  /// Torsion preferences pull in steps that consider contacts. Only for frames from one start: in a
  /// run, whose steps add up, they would resist continued pushes.
  bool has_torsion_preferences = false;
};

struct FrodaResult {
  /// Limits and least distances hold, loops are closed, and closing them moved no joint by more
  /// than 0.3 Angstrom at the end.
  bool is_whole = false;
  double max_limit = 0.0;    ///< largest distance of a limit outside its interval (Angstrom)
  double max_overlap = 0.0;  ///< largest overlap (Angstrom)
  double max_closing = 0.0;  ///< largest move of a joint by the steps that closed loops (Angstrom)
  int steps = 0;
  /// Bodies visited, over all steps. Molecules that nothing touched do not count.
  std::int64_t visits = 0;
};

/// Not thread-safe.
class FrodaFrame {
 public:
  /// Both must outlive it. `unit` (Angstrom) is the unit of lengths that bound steps, 1 for
  /// molecules.
  FrodaFrame(const Framework& framework, const BodyPlan& plan, double unit = 1.0);

  void begin(const FrodaPush& push, const FrodaOptions& options);

  // Each of these puts the request for the next step into request(), or returns false if there is
  // none. Pulls come first, then steps for contacts alone, then those that close loops.
  /// Pulls to targets at a share of the push. If it sees contacts, the step repairs them, too.
  void ask_for_pull(double share, bool sees_contacts);
  bool ask_for_careful_pull();
  bool ask_for_contacts();  ///< until all hold or nothing more is gained
  bool ask_for_closing();   ///< until loops are closed

  int legs() const { return legs_; }  ///< number of targets, at most a leg apart, with the last one
  const StepRequest& request() const { return request_; }
  std::span<Vec3> positions() { return x_; }  ///< of places, relative to the frame's own origin
  const WorkingTrees& working() const { return working_; }

  /// To be called after a step has moved the positions.
  void note_step();
  bool has_broken_contacts();  ///< at the start of a pull
  /// Returns the result and writes `out` (N).
  FrodaResult finish(std::span<Vec3> out);

 private:
  struct Violation {
    double limit = 0.0, overlap = 0.0;
  };

  int conjugate_gradients() const { return options_.is_careful ? options_.conjugate_gradients : 0; }
  void ask_for_pull(double share, double weight);
  void set_targets(double share);
  void set_targets_on_course(double share);
  double closing() const;
  Violation find_rows(double weight);
  void add_row(const DistanceRow& row, double broken);
  void find_limit_rows(double weight, Violation& worst);
  void find_steric_rows(double weight, Violation& worst);
  std::span<const TurnSpring> springs(bool are_wanted);

  const Framework& framework_;
  const BodyPlan& plan_;
  double unit_;
  FrodaOptions options_;
  LimitsOff limits_off_;
  const Course* course_ = nullptr;
  std::vector<Vec3> on_course_;  ///< (N)
  WorkingTrees working_;
  TurnSprings springs_;
  std::unique_ptr<NearPairs> pairs_;  ///< null: no sterics
  Vec3 origin_;
  std::vector<Vec3> x_, start_, push_, target_, before_;  ///< of places, from the origin
  double target_share_ = 0.0;  ///< share of the push at the present targets
  std::size_t bodies_with_targets_ = 0;
  std::vector<DistanceRow> rows_;
  StepRequest request_;
  bool is_looked_at_ = false;  ///< rows_ and worst_ belong to x_
  Violation worst_;
  int legs_ = 1;
  int pulls_ = 0, pushes_ = 0, closings_ = 0;  ///< numbers of requests
  // Progress of steps for contacts alone.
  double least_ = 0.0;
  int since_gain_ = 0;
  bool springs_let_go_ = false;
  int steps_ = 0;
  std::int64_t visits_ = 0;
};

}  // namespace pliant
