// SPDX-License-Identifier: MIT
// Reads the time-dependent part of an H5MD file.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/hdf5/hdf5_dataset.hpp"
#include "pliant/record/hdf5/hdf5_read.hpp"

namespace pliant {

/// Steps or times: one a frame (explicit), or a start and an increment, or none.
class Counter {
 public:
  /// Opens what is at `path`, if anything is.
  Counter(std::int64_t file, const std::string& path);

  bool exists() const { return dataset_.has_value(); }
  bool is_explicit() const { return exists() && !dataset_->extents().empty(); }
  const Hdf5Dataset& dataset() const { return *dataset_; }
  /// Number of frames covered; the largest possible number unless explicit.
  std::uint64_t count() const;
  /// T is double or std::int64_t.
  template <class T>
  T at(std::int64_t frame) const;
  template <class T>
  std::vector<T> all(std::int64_t frames) const;

 private:
  std::optional<Hdf5Dataset> dataset_;
  double increment_ = 1.0, offset_ = 0.0;
};

/// Frames of one group of an open HDF5 file; implements H5mdReader. Callers hold an Hdf5Session.
class FrameReader {
 public:
  /// `asked` is the name of the group, or "". Messages through `log` begin with `file_name`.
  FrameReader(std::int64_t file, const std::string& asked, const std::string& file_name,
              const Log& log);

  std::int64_t frames() const { return frames_; }
  std::int64_t frames_left_out() const { return frames_left_out_; }
  std::size_t joint_count() const { return joint_count_; }
  const std::string& group() const { return group_; }
  std::size_t bytes_per_coordinate() const { return value_->value_bytes(); }
  bool has_time() const { return time_->exists(); }

  std::vector<Vec3> positions(std::int64_t frame) const;
  void read_positions(std::int64_t frame, std::span<Vec3> positions) const;
  std::vector<Vec3> block(std::int64_t first, std::int64_t count) const;
  double rounded_to() const;
  std::int64_t step(std::int64_t frame) const;
  double time(std::int64_t frame) const;
  std::vector<std::int64_t> steps() const;
  std::vector<double> times() const;
  std::vector<std::string> observables() const;
  std::vector<double> observable(const std::string& name) const;
  SeriesKind kind_of(const std::string& observable) const;
  std::vector<std::uint8_t> contact_states() const;

 private:
  void open_positions();
  void open_units();
  void count_frames();
  void check_steps() const;
  void check_frame(std::int64_t frame) const;
  Hdf5Dataset open_observable(const std::string& name) const;

  std::int64_t file_;
  std::string file_name_;
  Log log_;
  std::string group_;
  std::string position_;  // "/particles/trajectory/position"
  std::optional<Hdf5Dataset> value_;
  std::optional<Counter> step_, time_;
  double length_factor_ = 1.0, time_factor_ = 1.0;
  std::size_t joint_count_ = 0;
  std::int64_t frames_ = 0, frames_left_out_ = 0;
};

}  // namespace pliant
