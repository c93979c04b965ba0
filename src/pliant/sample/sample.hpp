// SPDX-License-Identifier: MIT
// Samples the flexibility of a framework: frames with exact geometry around a start, along the
// modes of an elastic network or by another sampler.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "pliant/framework/framework.hpp"
#include "pliant/sample/network/elastic_network.hpp"
#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/sample_summary.hpp"

namespace pliant {

/// A frame; spans are valid during the call only.
struct SampledFrame {
  std::int64_t frame = 0;
  std::span<const Vec3> positions;  ///< (N) Angstrom
  /// (L) 1: the limit was switched off; empty: all were on
  std::span<const std::uint8_t> limits_off;
  double max_residual = 0.0, rms_residual = 0.0;
  double max_limit = 0.0, max_overlap = 0.0;  ///< Angstrom
  int redraws = 0;  ///< draws that were rejected before this one was resolved
  std::int64_t steps = 0;
};

/// Receives the frames in order, on the thread that called sample(). Returns true to stop.
using SampleObserver = std::function<bool(const SampledFrame&)>;

/// Samples frames about `start` (N, Angstrom), at which all bars must be whole. Each frame of
/// `modes` and `dilute` depends only on the framework, the start, the seed and its number, and so
/// neither on the number of threads nor on how a run is divided. Frames that cannot be resolved are
/// drawn again, and the summary counts them; every frame shown is whole. Throws OptionError for bad
/// options and nodes, and for frameworks with pinned joints or in a plane; InputError if the start
/// is not whole or violates limits.
SampleSummary sample(const Framework& framework, std::span<const Vec3> start, NetworkNodes nodes,
                     const SampleOptions& options, const SampleObserver& observer);

}  // namespace pliant
