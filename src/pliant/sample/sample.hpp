// SPDX-License-Identifier: MIT
// Samples the flexibility of a framework: frames with exact geometry around a start, along the
// modes of an elastic network or by another sampler.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/sample/network/elastic_network.hpp"
#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/sample_summary.hpp"

namespace pliant {

/// Sees each frame, in their order, on the thread that called sample(): as those of runs, with the
/// number of the frame for its step, and no time. True: stop.
using SampleObserver = std::function<bool(const Frame&)>;

/// Samples frames about `start` (N, Angstrom), at which all bars must be whole. Each frame of
/// `modes` and `dilute` depends only on the framework, the start, the seed and its number, and so
/// neither on the number of threads nor on how a run is divided. Frames that cannot be resolved are
/// drawn again, and the summary counts them; every frame shown is whole. Throws OptionError for bad
/// options and nodes, and for frameworks with pinned joints or in a plane; InputError if the start
/// is not whole, violates limits, or is so wide or so far from the origin that no frame would be
/// whole.
SampleSummary sample(const Framework& framework, std::span<const Vec3> start, NetworkNodes nodes,
                     const SampleOptions& options, const SampleObserver& observer);

}  // namespace pliant
