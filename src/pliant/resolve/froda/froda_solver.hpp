// SPDX-License-Identifier: MIT
// Resolves a framework with limits and sterics from any push, in torsion space: rigid units stay
// exact at every step while they are pulled towards where the joints were pushed, and are then
// pushed until every limit and every least distance holds. How and why: ../README.md, froda.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/framework/limits.hpp"
#include "pliant/resolve/froda/articulated_step.hpp"
#include "pliant/resolve/froda/near_pairs.hpp"
#include "pliant/resolve/froda/working_trees.hpp"

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
class FrodaSolver {
 public:
  /// Both outlive it. `unit` (Angstrom): of the lengths by which steps are bounded and damped, 1
  /// for molecules.
  FrodaSolver(const Framework& framework, const BodyPlan& plan, double unit = 1.0);

  /// `start` (N, Angstrom): all bars are whole. `target` (N): where the push wants the joints.
  /// Writes `out` (N; may be either): bars as whole as at the start, to rounding. A function of its
  /// arguments alone.
  FrodaOutcome resolve(std::span<const Vec3> start, std::span<const Vec3> target,
                       std::span<Vec3> out, const FrodaOptions& options = {},
                       LimitsOff limits_off = {});

 private:
  struct Violation {
    double limit = 0.0, overlap = 0.0;
  };

  void begin(std::span<const Vec3> start, std::span<const Vec3> target, bool is_careful);
  void pull(const FrodaOptions& options);
  bool pull_blindly(const FrodaOptions& options);
  std::size_t set_targets(double share, std::size_t first);
  double pull_to(double share, int steps, bool sees_contacts, const FrodaOptions& options);
  bool push_apart(const FrodaOptions& options, FrodaOutcome& outcome);
  bool finish(const FrodaOptions& options, FrodaOutcome& outcome);
  double close_loops();
  double widest_gap() const;
  Violation find_rows(double weight);
  void add_row(const ContactRow& row, double broken);
  void find_limit_rows(double weight, Violation& worst);
  void find_steric_rows(double weight, Violation& worst);
  double step(std::span<const Vec3> targets, double bound, int conjugate_gradients,
              bool has_springs);

  const Framework& framework_;
  const BodyPlan& plan_;
  double unit_;
  WorkingTrees working_;
  ArticulatedStep step_;
  std::unique_ptr<NearPairs> pairs_;  ///< null: no sterics
  LimitsOff limits_off_;
  double goal_ = 0.0;
  Vec3 origin_;
  std::vector<Vec3> x_, start_, push_, target_, before_;  ///< of places, from the origin
  std::vector<ContactRow> rows_;
  TurnSprings springs_;
  bool is_looked_at_ = false;  ///< rows_ and worst_ are those of x_
  Violation worst_;
  int steps_ = 0;
  std::int64_t visits_ = 0;
};

}  // namespace pliant
