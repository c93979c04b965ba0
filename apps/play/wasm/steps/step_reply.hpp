// SPDX-License-Identifier: MIT
// Replies that tell of one step.
#pragma once

#include "session.hpp"

namespace pliant::play {

/// Fields and positions of a step. `stopped` tells of one that the clock has ended: how far it was.
Reply reply_of(const StepReport& report);
/// The same, with what each bar has left, and had before it was resolved: (length - rest) / rest.
Reply with_bars(const StepReport& report, KeptResiduals& residuals);

}  // namespace pliant::play
