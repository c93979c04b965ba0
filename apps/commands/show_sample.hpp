// SPDX-License-Identifier: MIT
// The end of pliant sample --show: the page of pliant play.
#pragma once

#include "command.hpp"
#include "options/sample_settings.hpp"

namespace pliant::app {

/// Throws OptionError if frames of this output cannot be shown.
void check_show(const SampleSettings& settings);

/// Shows the frames if that was asked for and they were not ended early: then this process becomes
/// pliant play. Else returns `code`.
int shown(const SampleSettings& settings, int code);

}  // namespace pliant::app
