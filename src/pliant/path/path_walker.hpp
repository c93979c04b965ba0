// SPDX-License-Identifier: MIT
// Moves one molecule towards given places of its asked atoms, step by step, every step whole.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "pliant/path/ends.hpp"
#include "pliant/run/motion.hpp"

namespace pliant {

/// Where a walker was, and what it took to get there.
struct PathPlace {
  std::vector<Vec3> positions;  ///< (N) Angstrom
  std::int64_t sweeps = 0, projections = 0;
  double max_residual = 0.0, rms_residual = 0.0, max_limit = 0.0, max_overlap = 0.0;  ///< as Frame
};

using SharedPlace = std::shared_ptr<const PathPlace>;

/// How a step of a walker ended. Unless it is whole, nothing has moved.
enum class StepEnd : std::uint8_t { whole, not_whole, stopped };

class GoalPusher;

class PathWalker {
 public:
  /// The side must outlive it. A step that should_stop cuts short is told as stopped.
  PathWalker(const PathSide& side, std::function<bool()> should_stop);

  /// Asks for a step of r.m.s. `length` (Angstrom) towards goal (K), or all the way if that is
  /// nearer. drift: (R) Angstrom, by which each matched residue is asked to go besides; or none.
  StepEnd step(std::span<const Vec3> goal, double length, std::span<const Vec3> drift = {});
  /// The same without drift; one that cannot be made whole is asked for anew, half as long, and
  /// again.
  StepEnd whole_step(std::span<const Vec3> goal, double length);

  /// Goes on from a place where it was before.
  void put(SharedPlace place);

  const PathSide& side() const { return side_; }
  const SharedPlace& now() const { return now_; }
  std::vector<Vec3> asked() const;  ///< (K) Angstrom, where the asked atoms are
  /// r.m.s. distance of the asked atoms from places (K), which are superposed (Angstrom).
  double apart(std::span<const Vec3> goal) const;

 private:
  static SharedPlace place_of(const Frame& frame);

  const PathSide& side_;
  std::shared_ptr<GoalPusher> pusher_;
  Motion motion_;
  SharedPlace now_;
};

/// (K) Angstrom: from each of `here` to its goal, which is superposed first.
std::vector<Vec3> ways(std::span<const Vec3> here, std::span<const Vec3> goal);

/// r.m.s. length of moves (Angstrom); 0 of none.
double rms(std::span<const Vec3> moves);

/// The asked atoms of a side at `positions` (N).
std::vector<Vec3> asked_of(const PathSide& side, std::span<const Vec3> positions);

}  // namespace pliant
