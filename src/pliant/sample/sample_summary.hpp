// SPDX-License-Identifier: MIT
// Summary of a sample: exactness, rejected draws, and the fluctuation of each joint.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// What a sample did. It implies no populations: the amplitude is an input.
struct SampleSummary {
  std::int64_t frames = 0;
  std::int64_t redrawn = 0;        ///< frames whose first draw could not be resolved
  std::int64_t rescued = 0;        ///< frames that needed more than careful steps
  std::int64_t failed = 0;         ///< frames for which no draw was resolved; not among `frames`
  std::int64_t ligand_frames = 0;  ///< in which a ligand of a place has other torsions
  std::int64_t near_frames = 0;    ///< of these, around the start: fluctuations are theirs
  double amplitude_asked = 0.0;    ///< mean r.m.s. fluctuation of nodes (Angstrom); 0: the
                                   ///< sampler has none
  double amplitude_reached = 0.0;  ///< mean of `rmsf` over the joints nearest to nodes
  double max_residual = 0.0;       ///< worst bar: |length - rest| / rest
  BarIndex worst_bar = 0;
  double max_limit = 0.0;          ///< largest distance of a limit outside its interval (Angstrom)
  double max_overlap = 0.0;        ///< largest overlap of two joints (Angstrom)
  double max_closing = 0.0;        ///< largest move of a joint by the last steps that close loops
  double mean_off_target = 0.0;    ///< r.m.s. distance of joints from their targets
  double mean_let_go = 0.0;        ///< contacts that are off in a frame
  double mean_steps = 0.0;         ///< steps in torsion space a frame
  std::vector<double> rmsf;        ///< (N) r.m.s. fluctuation of each joint about its mean, frames
                                   ///< superposed: whole turns and shifts are no fluctuation
  std::vector<double> rmsf_error;  ///< (N) half the difference between halves of the frames
  bool stopped_by_caller = false;
  double seconds = 0.0;      ///< wall time
  double cpu_seconds = 0.0;  ///< of resolving, summed over threads
};

/// Warns if frames reached less than half of the amplitude asked for.
void warn_of_amplitude(const SampleSummary& summary, const Log& log);

/// Sums of positions and of their squares, for two halves of an ensemble. Frames are superposed on
/// the start, since the mean is known only after the last frame. If frames lie evenly about the
/// start, the mean is so near that fluctuations agree to a few parts in 1000.
class FluctuationSums {
 public:
  /// `start` (N) is subtracted from positions. `fitted`: joints by which frames are superposed.
  FluctuationSums(std::span<const Vec3> start, std::vector<std::size_t> fitted);

  /// Adds a frame to the first or the second half.
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
  std::vector<Vec3> goal_, points_;  ///< of the fitted joints, at the start and in a frame
  Half halves_[2];
};

}  // namespace pliant
