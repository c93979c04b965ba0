// SPDX-License-Identifier: MIT
// Steps on a way: towards one goal after another, until nothing is gained.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/path/path_walker.hpp"

namespace pliant {

/// A way ends where so many steps together gain less than least_gain (Angstrom).
inline constexpr std::size_t path_patience = 8;
inline constexpr double least_gain = 0.02;
inline constexpr double path_near = 0.5;  ///< a goal that is not the last is reached, Angstrom
inline constexpr std::size_t most_path_steps = 2000;

/// Where one walker was, and how far each place is from the last goal.
struct Way {
  std::vector<SharedPlace> places;
  std::vector<double> left;        ///< Angstrom
  std::vector<std::string> notes;  ///< why it ended, if not for want of gain

  void add(SharedPlace place, double apart) {
    places.push_back(std::move(place));
    left.push_back(apart);
  }
  /// Its first `count` places, without notes.
  Way first(std::size_t count) const;
};

/// Whether steps still gain.
class Patience {
 public:
  /// step: r.m.s. length of steps; begun: how far the goal is (Angstrom).
  Patience(double step, double begun);
  /// Notes how far the goal is; whether the last steps gained too little.
  bool is_over(double left);

 private:
  double least_;
  std::vector<double> seen_;
};

/// Goals before the last only show the way: one is left for the next where it is near, or where a
/// step gains little.
class March {
 public:
  /// Goes on from where the walker is, the last place of the way. goals: of K places each, at least
  /// one. Walker and way must outlive it.
  March(PathWalker& walker, Way& way, std::vector<std::vector<Vec3>> goals, double step);

  /// One step at most, which is added to the way. False where the way has ended. Of a step that was
  /// stopped nothing is kept, and it may be asked for again.
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
