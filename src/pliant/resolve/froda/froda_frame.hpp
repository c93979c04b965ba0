// SPDX-License-Identifier: MIT
// One frame on its way: where its joints are, where the push wants them, which contacts are broken,
// and so what its next step is asked for. Who takes the steps is left open: a FrodaSolver alone, or
// FrodaLanes for eight frames at once.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/framework/limits.hpp"
#include "pliant/resolve/froda/bodies/articulated_step.hpp"
#include "pliant/resolve/froda/bodies/working_trees.hpp"
#include "pliant/resolve/froda/near/near_pairs.hpp"

namespace pliant {

struct FrodaOptions {
  double limit = 0.08;    ///< Angstrom: how far a limit may be outside its interval
  double overlap = 0.08;  ///< Angstrom: how much nearer than allowed two joints may be
  /// Angstrom: steps end where both are below this, or gain no more.
  double goal = 0.02;
  /// Sees contacts at every step, and takes conjugate gradients in each: for pushes of more than
  /// some Angstrom, through which chains must not pass each other.
  bool is_careful = false;
  int conjugate_gradients = 2;  ///< of careful steps
  double leg = 2.0;             ///< Angstrom: targets on the way are no further apart
  int last_steps = 60;          ///< that contacts alone get
  /// Torsion preferences pull, in steps that see contacts. For frames that are made from one start:
  /// in a run, whose steps add up, they would hold back what is pushed on and on.
  bool has_torsion_preferences = false;
};

struct FrodaOutcome {
  /// Limits and least distances hold, loops are closed, and to close them no joint went further
  /// than 0.3 Angstrom at the end.
  bool is_whole = false;
  double max_limit = 0.0;    ///< largest distance of a limit outside its interval (Angstrom)
  double max_overlap = 0.0;  ///< largest overlap (Angstrom)
  double max_closing = 0.0;  ///< largest move of a joint by the steps that closed loops (Angstrom)
  int steps = 0;
  /// Over all steps: bodies that were looked at. Not those of molecules that nothing touched.
  std::int64_t visits = 0;
};

/// Not for two threads at once.
class FrodaFrame {
 public:
  /// Both outlive it. `unit` (Angstrom): of the lengths by which steps are bounded, 1 for
  /// molecules.
  FrodaFrame(const Framework& framework, const BodyPlan& plan, double unit = 1.0);

  /// `start` (N, Angstrom): all bars are whole. `target` (N): where the push wants the joints.
  void begin(std::span<const Vec3> start, std::span<const Vec3> target, const FrodaOptions& options,
             LimitsOff limits_off);

  // Each of these says in request() what the next step is asked for; false: there is none. All
  // pulls come first, then contacts alone, then loops.
  /// To targets at a share of the push. If it sees contacts, the step mends them too.
  void ask_for_pull(double share, bool sees_contacts);
  bool ask_for_careful_pull();
  bool ask_for_contacts();  ///< until all hold or nothing is gained any more
  bool ask_for_closing();   ///< until loops are closed

  int legs() const { return legs_; }  ///< targets, at most a leg apart, the last one included
  const StepRequest& request() const { return request_; }
  std::span<Vec3> positions() { return x_; }  ///< of places, from the frame's own origin
  const WorkingTrees& working() const { return working_; }

  /// After a step has moved the positions.
  void note_step();
  bool has_broken_contacts();  ///< at the start of a pull
  /// The outcome; writes `out` (N).
  FrodaOutcome finish(std::span<Vec3> out);

 private:
  struct Violation {
    double limit = 0.0, overlap = 0.0;
  };

  int conjugate_gradients() const { return options_.is_careful ? options_.conjugate_gradients : 0; }
  void set_targets(double share);
  double closing() const;
  double widest_gap() const;
  Violation find_rows(double weight);
  void add_row(const ContactRow& row, double broken);
  void find_limit_rows(double weight, Violation& worst);
  void find_steric_rows(double weight, Violation& worst);
  std::span<const TurnSpring> springs(bool are_wanted);

  const Framework& framework_;
  const BodyPlan& plan_;
  double unit_;
  FrodaOptions options_;
  LimitsOff limits_off_;
  WorkingTrees working_;
  TurnSprings springs_;
  std::unique_ptr<NearPairs> pairs_;  ///< null: no sterics
  Vec3 origin_;
  std::vector<Vec3> x_, start_, push_, target_, before_;  ///< of places, from the origin
  double target_share_ = 0.0;                             ///< of the push, at which targets are
  std::size_t bodies_with_targets_ = 0;
  std::vector<ContactRow> rows_;
  StepRequest request_;
  bool is_looked_at_ = false;  ///< rows_ and worst_ are those of x_
  Violation worst_;
  int legs_ = 1;
  int pulls_ = 0, pushes_ = 0, closings_ = 0;  ///< that were asked for
  // of contacts alone
  double least_ = 0.0;
  int since_gain_ = 0;
  bool springs_let_go_ = false;
  int steps_ = 0;
  std::int64_t visits_ = 0;
};

}  // namespace pliant
