// SPDX-License-Identifier: MIT
// Settings of the session as JSON: rows of run_fields(), by name.
#pragma once

#include "pliant/run/run_fields.hpp"
#include "reply.hpp"

namespace pliant::play {

/// `options` with those settings that `fields` names. A seed may be text. Throws OptionError for a
/// value of another kind; names that are no settings are left alone.
RunOptions with_settings(RunOptions options, const Json& fields);

/// Whether an option of a run means nothing here: how many steps, which are shown.
bool is_no_setting(const RunField& field);

/// All settings in force.
Json settings_of(const RunOptions& options);

}  // namespace pliant::play
