// SPDX-License-Identifier: MIT
// A run as H5MD files keep it: its options, for it to go on.
#pragma once

#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"
#include "pliant/run/run_options.hpp"

namespace pliant {

/// How a run goes on, with its replay, its guide and its ordering. Throws InputError naming the
/// file and a path of it that is missing or has an invalid value, or a guide that it does not hold.
RunOptions run_options_from(const H5mdCheckpoint& recorded);

}  // namespace pliant
