// SPDX-License-Identifier: MIT
// Steps on a way: towards one goal after another, until nothing more is gained.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/path/path_walker.hpp"

namespace pliant {

/// A way ends when path_patience steps together gain less than least_gain (Angstrom).
inline constexpr std::size_t path_patience = 8;
inline constexpr double least_gain = 0.02;
/// Angstrom at which an intermediate goal counts as reached
inline constexpr double path_near = 0.5;
inline constexpr std::size_t most_path_steps = 2000;

/// The places of one walker, and their distances from the last goal.
struct Way {
  std::vector<SharedPlace> places;
  std::vector<double> left;        ///< Angstrom
  std::vector<std::string> notes;  ///< why it ended, unless steps gained too little
  double turned = 0.0;  ///< degrees: largest turn of a piece that it began with; 0: straight

  void add(SharedPlace place, double apart) {
    places.push_back(std::move(place));
    left.push_back(apart);
  }
  /// Its first `count` places, without notes.
  Way first(std::size_t count) const;
};

/// Decides whether steps still gain.
class Patience {
 public:
  /// step: r.m.s. length of steps; begun: first distance of the goal (Angstrom).
  Patience(double step, double begun);
  /// Notes the distance of the goal. Returns whether the last steps gained too little.
  bool is_over(double left);

 private:
  double least_;
  std::vector<double> seen_;
};

/// Intermediate goals only show the way: the next one replaces a goal that is near, or towards
/// which a step gains little.
class March {
 public:
  /// Continues from the walker's position, the last place of the way. goals: at least one, of K
  /// positions each. Walker and way must outlive it.
  March(PathWalker& walker, Way& way, std::vector<std::vector<Vec3>> goals, double step);

  /// Makes at most one step and adds it to the way. Returns false where the way has ended. A step
  /// that was stopped leaves no trace and may be repeated.
  bool advance();

 private:
  void aim(std::size_t goal);
  bool is_last() const { return goal_ + 1 == goals_.size(); }
  bool is_full() const { return way_.places.size() > most_path_steps; }
  bool pass();
  bool arrive();
  bool end(const std::string& why);

  PathWalker& walker_;
  Way& way_;
  std::vector<std::vector<Vec3>> goals_;
  double step_;
  std::size_t goal_ = 0;
  double apart_ = 0.0;  ///< from the goal aimed at, Angstrom
  std::optional<Patience> patience_;
};

}  // namespace pliant
