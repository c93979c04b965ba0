// SPDX-License-Identifier: MIT
// A sample in an H5MD file: options, nodes and frames, from which it can continue.
#pragma once

#include <span>
#include <vector>

#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"
#include "pliant/sample/sample.hpp"
#include "pliant/sample/sample_fields.hpp"

namespace pliant {

/// The inputs of a sample besides framework and options. `start` (N, Angstrom).
RunInputs sample_inputs(std::span<const Vec3> start, const NetworkNodes& nodes);

/// The recorded nodes.
NetworkNodes nodes_of(const RunInputs& inputs);

/// Options with which a sample continues: for the missing frames, and for the last existing one,
/// which must come out with the same bits. Throws InputError naming the file and a path in it that
/// is missing or has an invalid value.
SampleOptions sample_options_from(const H5mdCheckpoint& recorded);

/// Adds to the file of `from` the frames that `options` (sample_options_from) ask for; the first of
/// these is the last existing one. `observer` receives the new frames, and only these are counted.
/// Throws as sample() and H5mdRecorder do; FileError if the last frame comes out differently.
SampleSummary add_frames(const H5mdCheckpoint& from, const SampleOptions& options,
                         const H5mdOptions& recording, const SampleObserver& observer);

}  // namespace pliant
