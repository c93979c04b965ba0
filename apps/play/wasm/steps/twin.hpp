// SPDX-License-Identifier: MIT
// A second walker beside the session's: it makes the same steps with another technique.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "kept_residuals.hpp"
#include "steps/made_step.hpp"

namespace pliant::play {

class Twin {
 public:
  /// Starts at `state`. The framework must outlive it. Throws OptionError if the technique cannot
  /// resolve the framework.
  Twin(const Framework& framework, const State& state, const RunOptions& options,
       const Technique& technique, std::shared_ptr<StepClock> clock);

  const Technique& technique() const { return technique_; }
  const Framework& framework() const { return walk_.framework(); }
  const State& state() const { return walk_.state(); }
  KeptResiduals& residuals() { return *residuals_; }

  /// Makes a step of the session with all its settings but the technique; watched, if `on_bar`.
  StepReport step(const MadeStep& step, const std::function<void(const RepairedBar&)>* on_bar);

 private:
  /// The settings of a step, with the technique of the twin.
  void take(const MadeStep& step);

  const Framework& framework_;
  Technique technique_;
  std::shared_ptr<StepClock> clock_;
  SteeredWalk walk_;
  std::optional<KeptResiduals> residuals_;
  MadeStep last_;  ///< whose settings are in force
};

}  // namespace pliant::play
