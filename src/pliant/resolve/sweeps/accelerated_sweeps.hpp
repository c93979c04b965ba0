// SPDX-License-Identifier: MIT
// Sweeps of bars on positions of their own, with Anderson acceleration that guards itself:
// - An extrapolation moves the joints no further than all sweeps and extrapolations before it.
// - A step of extrapolation after which a sweep moves the joints more than twice as far as the
//   sweep before is taken back.
// - Sweeps are accelerated for a while, then plain from the start for as long, then accelerated
//   from where that was left for twice as long, and so on. What P plain sweeps resolve takes at
//   most 3 P + 50 sweeps, wherever extrapolation leads.
#pragma once

#include <span>
#include <vector>

#include "pliant/resolve/sweeps/anderson.hpp"
#include "pliant/resolve/sweeps/limit_sweep.hpp"
#include "pliant/resolve/sweeps/sweep_plan.hpp"

namespace pliant {

class AcceleratedSweeps {
 public:
  static constexpr std::int64_t first_stretch = 50;  ///< sweeps

  /// `joints` are the ends of all bars, sorted. `limits` are swept too, unless null; the joints
  /// must then be all joints of the framework.
  AcceleratedSweeps(std::vector<Joint> joints, LimitSweep* limits);

  void clear_plan() { plan_.clear(); }
  /// `visit` names joints of the framework.
  void add(PlannedBar visit);

  /// Takes the positions of its joints out of all `positions`.
  void begin(std::span<const Vec3> positions);
  /// Puts the positions of this moment back to where begin() took them from.
  void put_into(std::span<Vec3> positions) const;

  /// Are the bars whole, by the last look?
  Look state() const { return state_; }
  /// Projects each bar once; then looks, and goes further on the accelerated track. Returns how
  /// many bars and limits were looked at.
  std::int64_t sweep(const RandomKey& key);

 private:
  Joint place(Joint joint) const;
  void accelerate(const RandomKey& key);
  void sweep_once(const RandomKey& key);
  Look look();
  void change_track();
  void go_no_further_than_the_path();

  std::vector<Joint> joints_;
  LimitSweep* limits_;  ///< null: there are none
  SweepPlan plan_;
  std::int64_t looked_at_limits_ = 0;  ///< in this sweep
  Look state_ = Look::broken;
  std::vector<Vec3> x_;       ///< (joints) where sweeps happen
  std::vector<Vec3> other_;   ///< the track that rests: plain while accelerated, and the reverse
  std::vector<Vec3> f_;       ///< what a sweep did
  std::vector<Vec3> last_g_;  ///< after the sweep before the last extrapolation
  AndersonMixing mixing_;
  double last_step_ = 0.0;     ///< square of how far the last accelerated sweep moved the joints
  double path_ = 0.0;          ///< summed lengths of accelerated sweeps and extrapolations
  bool extrapolated_ = false;  ///< x_ is an extrapolation of the last sweep
  bool on_plain_track_ = false;
  std::int64_t stretch_ = first_stretch, left_ = first_stretch;  ///< sweeps
};

}  // namespace pliant
