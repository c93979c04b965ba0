// SPDX-License-Identifier: MIT
// The part of our H5MD files that grows with each frame: positions, step, time and observables.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pliant/framework/frame.hpp"
#include "pliant/framework/measures/limit_counts.hpp"
#include "pliant/record/h5md/h5md_header.hpp"
#include "pliant/record/h5md/h5md_series.hpp"

namespace pliant {

/// Up to here outside its interval (Angstrom) a limit counts as held: what any way of resolving
/// leaves is less, and what a bond of hydrogen shrugs off is more.
inline constexpr double held_within = 0.1;

/// What decides which series a file has, besides its framework.
struct FrameOrigin {
  bool is_sample = false;
  bool several_walkers = false;
  bool has_limits_or_sterics = false;  ///< which may be of joints that are not recorded
};

/// All series of a file. Frames wait in memory between add() and write().
class FrameSeries {
 public:
  /// Makes empty series in the HDF5 file `file` (hid_t). Throws FileError.
  FrameSeries(std::int64_t file, const Framework& framework, const H5mdOptions& options,
              const FrameOrigin& origin);

  /// Opens the series of a file, to go on after its first `frames` frames. Throws FileError.
  FrameSeries(std::int64_t file, const Framework& framework, std::uint64_t frames);

  /// Cuts off steps of frames beyond those: readers see these frames no more.
  void cut() { positions_[2].cut(); }

  void add(const Frame& frame);
  /// Whether the last frame of the file has these positions, bit by bit as they are recorded.
  bool last_is(std::span<const Vec3> positions) const;
  /// Hands the waiting frames to HDF5. Throws FileError.
  void write();

  bool is_single() const { return single_; }
  std::uint64_t waiting_frames() const { return waiting_frames_; }
  std::size_t waiting_bytes() const { return waiting_frames_ * frame_bytes_; }

  /// Addresses of the series' object headers in the order in which their extents must grow: a
  /// reader that finds a step finds all else of the frame, and MDAnalysis, which counts frames by
  /// positions, ends at the first step it does not find.
  std::vector<std::uint64_t> addresses(std::int64_t file) const;

 private:
  void count_bytes(std::size_t joint_count);
  void make_positions(std::int64_t file, std::size_t joint_count, const H5mdOptions& options);
  void make_observables(std::int64_t file);
  void make_contact_states(std::int64_t file);
  void add_positions(std::span<const Vec3> positions);
  void add_coordinate(double coordinate);
  double as_recorded(double coordinate) const;

  bool single_;
  double unit_ = 0.0;  ///< positions are whole multiples of it (Angstrom); 0: they are as they are
  std::vector<std::size_t> rows_;  ///< of the table of observables, that this file has
  LimitCounter contacts_;
  std::size_t frame_bytes_ = 0;
  std::uint64_t waiting_frames_ = 0;
  std::vector<Series> positions_;    // value, time, step
  std::vector<Series> observables_;  // (rows)
  std::optional<Series> states_;     // of contacts; none without limits, and in files before 0.3.0
};

}  // namespace pliant
