// SPDX-License-Identifier: MIT
// Moves one molecule towards given positions of its asked atoms, step by step, every step whole.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "pliant/path/ends.hpp"
#include "pliant/run/motion.hpp"

namespace pliant {

/// A place of a walker, and the cost of the step to it.
struct PathPlace {
  std::vector<Vec3> positions;  ///< (N) Angstrom
  std::int64_t sweeps = 0, projections = 0;
  double max_residual = 0.0, rms_residual = 0.0, max_limit = 0.0, max_overlap = 0.0;  ///< as Frame
};

using SharedPlace = std::shared_ptr<const PathPlace>;

/// How a step of a walker ended. Only a whole step moves anything.
enum class StepEnd : std::uint8_t { whole, not_whole, stopped };

class GoalPusher;

class PathWalker {
 public:
  /// The side must outlive it. A step that should_stop cuts short ends as stopped.
  PathWalker(const PathSide& side, std::function<bool()> should_stop);

  /// Makes a step of r.m.s. `length` (Angstrom) towards goal (K), or all the way if that is nearer.
  /// drift: (R) Angstrom, an additional displacement asked of each matched residue; or empty.
  StepEnd step(std::span<const Vec3> goal, double length, std::span<const Vec3> drift = {});
  /// The same without drift. A step that cannot be made whole is repeated with half the length, and
  /// so on.
  StepEnd whole_step(std::span<const Vec3> goal, double length);

  /// Continues from an earlier place.
  void put(SharedPlace place);

  const PathSide& side() const { return side_; }
  const SharedPlace& now() const { return now_; }
  std::vector<Vec3> asked() const;  ///< (K) Angstrom, positions of the asked atoms
  /// r.m.s. distance of the asked atoms from `goal` (K) after superposition (Angstrom).
  double apart(std::span<const Vec3> goal) const;

 private:
  static SharedPlace place_of(const Frame& frame);

  const PathSide& side_;
  std::shared_ptr<GoalPusher> pusher_;
  Motion motion_;
  SharedPlace now_;
};

/// (K) Angstrom: vectors from `here` to the goals, which are superposed first.
std::vector<Vec3> ways(std::span<const Vec3> here, std::span<const Vec3> goal);

/// r.m.s. length of moves (Angstrom); 0 if there are none.
double rms(std::span<const Vec3> moves);

/// Positions of a side's asked atoms at `positions` (N).
std::vector<Vec3> asked_of(const PathSide& side, std::span<const Vec3> positions);

}  // namespace pliant
