// SPDX-License-Identifier: MIT
// A sample as H5MD files keep it: its options, its nodes and its frames, for it to go on.
#pragma once

#include <span>
#include <vector>

#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"
#include "pliant/sample/sample.hpp"
#include "pliant/sample/sample_fields.hpp"

namespace pliant {

/// What a sample is given besides them. `start` (N, Angstrom).
RunInputs sample_inputs(std::span<const Vec3> start, const NetworkNodes& nodes);

/// The nodes that were recorded.
NetworkNodes nodes_of(const RunInputs& inputs);

/// How a sample goes on: options of the frames that are missing, and of the last one that is there,
/// which must come out with the same bits. Throws InputError naming the file and a path of it that
/// is missing or has an invalid value.
SampleOptions sample_options_from(const H5mdCheckpoint& recorded);

/// Adds to the file of `from` the frames that `options` (sample_options_from) ask for, first among
/// them the last one that is there. `observer` sees those that are new, and only they are counted.
/// Throws as sample() and H5mdRecorder do; FileError where that frame comes out otherwise.
SampleSummary add_frames(const H5mdCheckpoint& from, const SampleOptions& options,
                         const H5mdOptions& recording, const SampleObserver& observer);

}  // namespace pliant
