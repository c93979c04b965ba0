// SPDX-License-Identifier: MIT
// A run as H5MD files keep it, for it to go on: its options, and what it was given besides.
#pragma once

#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"
#include "pliant/run/run_options.hpp"

namespace pliant {

/// What a run is given besides parameters: forces of a replay, a guide, an ordering.
RunInputs run_inputs(const RunOptions& options);

/// How a run goes on, with its replay, its guide and its ordering. Throws InputError naming the
/// file and a path of it that is missing or has an invalid value, or a guide that it does not hold.
RunOptions run_options_from(const H5mdCheckpoint& recorded);

}  // namespace pliant
