// SPDX-License-Identifier: MIT
// Samples the flexibility of a framework: frames with exact geometry around a start, along the
// modes of an elastic network or by another way of the table.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "pliant/base/log.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/sample/elastic_network.hpp"
#include "pliant/sample/sample_summary.hpp"

namespace pliant {

inline constexpr double usual_amplitude = 1.4;  // Angstrom

/// What to sample. Checked once, when sample() begins.
struct SampleOptions {
  std::int64_t frames = 200;           ///< from 1
  std::int64_t first_frame = 0;        ///< frames [first_frame, first_frame + frames) of the run
  double amplitude = usual_amplitude;  ///< mean r.m.s. fluctuation of nodes (Angstrom), 0.01 to 10
  std::uint64_t seed = 0;
  int threads = 1;                 ///< from 1; changes no result
  std::string network = "shared";  ///< a name in networks()
  std::string sampler = "modes";   ///< a name in samplers()
  /// kcal/mol, of `dilute`: a contact of energy E is off with probability exp(-|E| / this).
  double contact_energy = 3.0;
  /// Asked between batches of frames, each of which takes up to about a second.
  std::function<bool()> should_stop = {};
  Log log = {};  ///< of what would surprise
};

/// Throws OptionError naming the option, its value and its range.
void check(const SampleOptions& options);

/// A frame; spans are valid during the call only.
struct SampledFrame {
  std::int64_t frame = 0;
  std::span<const Vec3> positions;           ///< (N) Angstrom
  std::span<const std::uint8_t> limits_off;  ///< (L) 1: was off; empty: none was
  double max_residual = 0.0, rms_residual = 0.0;
  double max_limit = 0.0, max_overlap = 0.0;  ///< Angstrom
  int redraws = 0;  ///< draws that were given up before this one was resolved
  std::int64_t steps = 0;
};

/// Sees each frame, in their order, on the thread that called sample(). True: stop.
using SampleObserver = std::function<bool(const SampledFrame&)>;

/// Samples frames about `start` (N, Angstrom), at which all bars are whole. Each frame of `modes`
/// and `dilute` is a function of the framework, the start, the seed and its number alone, and so
/// the same for any number of threads and in whatever pieces a run is made. Frames that cannot be
/// resolved are drawn anew, and told; none is shown that is not whole.
/// Throws OptionError, for bad options and nodes, and for frameworks with pinned joints or in a
/// plane; InputError if the start is not whole or limits do not hold there.
SampleSummary sample(const Framework& framework, std::span<const Vec3> start, NetworkNodes nodes,
                     const SampleOptions& options, const SampleObserver& observer);

}  // namespace pliant
