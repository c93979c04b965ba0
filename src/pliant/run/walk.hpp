// SPDX-License-Identifier: MIT
// The steps of one walker in three parts, so that several walkers can be resolved at once.
#pragma once

#include <memory>
#include <optional>

#include "pliant/framework/measures/kept_measure.hpp"
#include "pliant/perturb/push_chain.hpp"
#include "pliant/run/motion.hpp"

namespace pliant {

/// A step is push(), then resolve() or whatever else resolves the positions, then finish().
class Walk {
 public:
  /// Framework and state must outlive it. Throws as Motion.
  Walk(const Framework& framework, State& state, const MotionOptions& options,
       std::uint64_t walker);

  void add(std::shared_ptr<Pusher> pusher) { pushers_.add(std::move(pusher)); }

  /// Makes the start whole if it is not.
  void start(Resolver& resolver);
  void push();
  /// What a resolve has to look at after the push.
  Disturbed disturbed() const;
  /// Whether positions after the push are finite; only then is there anything to resolve.
  bool is_finite_after_push() const;
  ResolveSummary resolve(Resolver& resolver);
  /// Returns false if the step was cut short, and taken back.
  bool finish(ResolveSummary resolved);
  /// Takes back a push that has not been finished.
  void take_back_push();

  Frame frame();
  const Push& pushed() const { return pushers_.pushed(); }
  /// How the last resolve ended, before anything was taken back.
  const ResolveSummary& resolved() const { return resolved_; }
  const State& state() const { return state_; }
  std::span<Vec3> positions() { return state_.positions; }
  /// The state, which the caller may change.
  State& change_state();
  std::uint64_t number() const { return number_; }
  const RunSummary& summary() const { return summary_; }
  bool is_over() const { return is_stopped_ || pushers_.is_over(); }
  void stop() { is_stopped_ = summary_.stopped_by_caller = true; }

 private:
  ResidualSummary measured() const;
  std::string what_is_missed(const ResidualSummary& start) const;
  void measure_all(ResolveSummary& resolved);
  void note(const ResolveSummary& resolved);
  ResolveSummary resolve_disturbed(Resolver& resolver, const Disturbed& disturbed);

  const Framework& framework_;
  State& state_;
  std::uint64_t number_;
  ResolveOptions resolve_;
  Log log_;
  PushChain pushers_;
  RunSummary summary_;
  ResolveSummary last_;                ///< of the last step, or of the start
  ResolveSummary resolved_;            ///< as it left the positions, whatever came after it
  std::unique_ptr<KeptMeasure> kept_;  ///< of frames with limits; null: not needed yet
  std::optional<bool> is_whole_;       ///< all bars, before the push; none: not checked
  bool continues_ = false;             ///< nobody but the last resolve has moved joints since
  bool is_pushed_ = false;             ///< a step has begun and not ended
  bool is_stopped_ = false;
};

}  // namespace pliant
