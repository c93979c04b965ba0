// SPDX-License-Identifier: MIT
// Replies that tell of one step.
#pragma once

#include <functional>

#include "session.hpp"

namespace pliant::play {

using OnBar = std::function<void(const RepairedBar&)>;

/// Fields and positions of a step. `stopped` tells of one that the clock has ended: how far it was.
Reply reply_of(const StepReport& report);
/// The same, with what each bar has left, and had before it was resolved: (length - rest) / rest.
Reply with_bars(const StepReport& report, KeptResiduals& residuals);
/// The same, with all visits of the step to bars. `step` makes it, watched or, with a null pointer,
/// not: techniques that are no orderings refuse to be watched; `events` is then null.
Reply film_of(const std::function<StepReport(const OnBar*)>& step, KeptResiduals& residuals);

}  // namespace pliant::play
