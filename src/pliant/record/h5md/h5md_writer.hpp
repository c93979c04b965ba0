// SPDX-License-Identifier: MIT
// Implements H5mdRecorder: the file, its series and its checkpoint, and when they are committed.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "pliant/record/h5md/h5md_checkpoint.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"
#include "pliant/record/h5md/h5md_frames.hpp"
#include "pliant/record/h5md/h5md_header.hpp"
#include "pliant/record/h5md/saved_part.hpp"
#include "pliant/record/hdf5/committed_file.hpp"
#include "pliant/record/hdf5/hdf5_session.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {

/// See H5mdRecorder.
class H5mdWriter {
 public:
  H5mdWriter(const std::filesystem::path& path, const Framework& framework,
             const H5mdHeader& header, const H5mdOptions& options);
  /// Continues after the frames that are kept.
  H5mdWriter(const H5mdCheckpoint& from, const H5mdOptions& options);
  ~H5mdWriter();

  void record(const Frame& frame);
  void end_run(const State& state);
  void flush();
  void close();

  std::int64_t frames() const { return frames_; }
  std::int64_t committed_frames() const { return committed_frames_; }
  const std::filesystem::path& path() const { return output_.target(); }

 private:
  using Clock = std::chrono::steady_clock;

  template <class Make>
  void open(Make make);
  void create(const Framework& framework, const H5mdHeader& header);
  void write_all(const Framework& framework, const H5mdHeader& header);
  void write_part(const Framework& framework, const H5mdHeader& header);
  void go_on(const H5mdCheckpoint& from);
  void check_frame(const Frame& frame) const;
  void check_known_frame(const Frame& frame);
  std::string joint_label(std::size_t joint) const;
  bool is_checkpoint_due(const Frame& frame) const;
  template <class Write>
  void write_to_file(Write write);
  void write_waiting();
  void commit();
  void commit_checkpoint(const Frame& frame);
  void publish();
  [[noreturn]] void fail(const std::string& reason);
  void throw_if_failed() const;
  void release();

  const std::size_t joint_count_;
  const std::shared_ptr<const AtomTable> atoms_;
  const H5mdOptions options_;
  // Destroyed in reverse order: HDF5 releases the file before it is closed.
  OutputFile output_;
  CommittedFile file_;
  Hid hdf5_;
  std::optional<SavedPart> part_;  ///< none: all joints are recorded
  std::unique_ptr<FrameSeries> series_;
  std::unique_ptr<CheckpointWriter> checkpoint_;
  std::int64_t frames_ = 0, committed_frames_ = 0;
  std::int64_t last_step_ = std::numeric_limits<std::int64_t>::min();
  std::int64_t last_walker_ = 0;
  std::int64_t known_to_ = last_step_;  ///< steps up to this one were recorded by an earlier run
  Clock::time_point last_commit_ = Clock::now(), last_checkpoint_ = {};
  std::string failure_;  // error that all later calls throw
};

}  // namespace pliant
