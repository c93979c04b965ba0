// SPDX-License-Identifier: MIT
// What an ensemble of frames came to: how exact, how many were drawn again, and how far each joint
// moves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// What sampling did. No claim about populations follows from it: amplitude is an input.
struct SampleSummary {
  std::int64_t frames = 0;
  std::int64_t redrawn = 0;        ///< frames whose first draw could not be resolved
  std::int64_t rescued = 0;        ///< frames that careful steps did not resolve
  std::int64_t failed = 0;         ///< frames that no draw gave; not among `frames`
  double amplitude_asked = 0.0;    ///< mean r.m.s. fluctuation of nodes (Angstrom); 0: the
                                   ///< sampler has none
  double amplitude_reached = 0.0;  ///< mean of `rmsf` over the joints nearest to nodes
  double max_residual = 0.0;       ///< worst bar: |length - rest| / rest
  BarIndex worst_bar = 0;
  double max_limit = 0.0;          ///< largest distance of a limit outside its interval (Angstrom)
  double max_overlap = 0.0;        ///< largest overlap of two joints (Angstrom)
  double max_closing = 0.0;        ///< largest move of a joint by the last steps that close loops
  double mean_off_target = 0.0;    ///< r.m.s. distance of joints from where they were asked to go
  double mean_steps = 0.0;         ///< of a frame, in torsion space
  std::vector<double> rmsf;        ///< (N) r.m.s. fluctuation of each joint about its mean, frames
                                   ///< superposed: whole turns and shifts are no fluctuation
  std::vector<double> rmsf_error;  ///< (N) half the difference between halves of the frames
  bool stopped_by_caller = false;
  double seconds = 0.0;      ///< of wall time, all of it
  double cpu_seconds = 0.0;  ///< of resolving, summed over threads
};

/// Warns where frames reached less than half of the amplitude that was asked for.
void warn_of_amplitude(const SampleSummary& summary, const Log& log);

/// Sums of places and of their squares, of two halves of an ensemble. Frames are superposed on the
/// start, not on their mean, which is not known before the last of them: frames that lie evenly
/// about the start have a mean so near to it that their fluctuations are the same to a few parts in
/// 1000.
class FluctuationSums {
 public:
  /// `start` (N): sums are of what differs from it. `fitted`: joints by which frames are
  /// superposed.
  FluctuationSums(std::span<const Vec3> start, std::vector<std::size_t> fitted);

  /// A frame of the first or the second half.
  void add(std::span<const Vec3> positions, bool is_second);

  /// (N) r.m.s. distance from the mean.
  std::vector<double> rmsf() const;
  /// (N) half the difference between the two halves; 0 if one has no frames.
  std::vector<double> error() const;

 private:
  struct Half {
    std::int64_t frames = 0;
    std::vector<Vec3> sum;
    std::vector<double> squares;
  };
  static std::vector<double> rmsf_of(const Half& half);

  std::vector<Vec3> start_;
  std::vector<std::size_t> fitted_;
  std::vector<Vec3> goal_, points_;  ///< of the fitted joints: at the start, in a frame
  Half halves_[2];
};

}  // namespace pliant
