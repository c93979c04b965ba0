// SPDX-License-Identifier: MIT
// The time-dependent part of our H5MD files: positions, step, time and observables.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "pliant/framework/frame.hpp"
#include "pliant/framework/measures/limit_counts.hpp"
#include "pliant/record/h5md/h5md_header.hpp"
#include "pliant/record/h5md/h5md_series.hpp"

namespace pliant {

/// A limit counts as held up to this distance (Angstrom) outside its interval. All ways of
/// resolving leave less; hydrogen bonds tolerate more.
inline constexpr double held_within = 0.1;

/// What decides which series a file has, besides its framework.
struct FrameOrigin {
  bool is_sample = false;
  bool several_walkers = false;
  bool has_limits_or_sterics = false;  ///< of any joint, recorded or not
};

/// All series of a file. Frames wait in memory between add() and write().
/// The series of a file. Frames wait in memory between add() and write().
class FrameSeries {
 public:
  /// Makes empty series in the HDF5 file `file` (hid_t). Throws FileError.
  FrameSeries(std::int64_t file, const Framework& framework, const H5mdOptions& options,
              const FrameOrigin& origin);

  /// Opens the series of a file, to continue after its first `frames` frames. Throws FileError.
  FrameSeries(std::int64_t file, const Framework& framework, std::uint64_t frames);

  /// Cuts off the steps of later frames, so that readers no longer see these.
  void cut() { positions_[2].cut(); }

  void add(const Frame& frame);
  /// Whether the last frame of the file has these positions, bit by bit after rounding as recorded.
  bool last_is(std::span<const Vec3> positions) const;
  /// Their positions, which stay where they are from one write() to the next.
  std::span<const std::byte> waiting_positions() const { return positions_[0].waiting(); }
  /// Passes the waiting frames to HDF5. Throws FileError.
  void write();

  std::uint64_t waiting_frames() const { return waiting_frames_; }
  std::size_t waiting_bytes() const { return waiting_frames_ * frame_bytes_; }

  /// Addresses of the series' object headers in the order in which their extents must grow: a
  /// reader that finds a step finds everything else of the frame. MDAnalysis counts frames by
  /// positions and stops at the first missing step.
  std::vector<std::uint64_t> addresses(std::int64_t file) const;

 private:
  void count_bytes(std::size_t joint_count);
  void make_positions(std::int64_t file, std::size_t joint_count);
  void make_observables(std::int64_t file);
  void make_contact_states(std::int64_t file);
  void add_positions(std::span<const Vec3> positions);
  double as_recorded(double coordinate) const;

  double unit_ = 0.0;  ///< positions are rounded to multiples of it (Angstrom); 0: not rounded
  std::vector<std::size_t> rows_;  ///< rows of the table of observables that this file has
  LimitCounter contacts_;
  std::size_t frame_bytes_ = 0;
  std::uint64_t waiting_frames_ = 0;
  std::vector<Series> positions_;    // value, time, step
  std::vector<Series> observables_;  // (rows)
  std::optional<Series> states_;     // of contacts; none without limits
};

}  // namespace pliant
