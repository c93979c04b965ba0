// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_writer.hpp"

#include <hdf5.h>

#include <cmath>

#include "pliant/base/error.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/system/signals.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_static.hpp"
#include "pliant/record/hdf5/committed_driver.hpp"
#include "pliant/record/hdf5/hdf5_write.hpp"

namespace pliant {
namespace {

// Frames that wait in memory are handed to HDF5 when they take this many bytes: few enough to stay
// in the processor's cache.
constexpr std::size_t most_waiting_bytes = std::size_t{1} << 20;

// They are committed then only if so much time (s) has gone by since the last commit: a reader
// takes some milliseconds to open a file, and a commit must rarely fall into them.
constexpr double least_seconds_of_a_commit = 0.2;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::size_t checked_joint_count(const Framework& framework) {
  if (framework.joint_count() == 0)
    throw InputError("a framework without joints has no trajectory");
  return framework.joint_count();
}

/// What a run goes on from, as a frame shows it.
Frame frame_of(const State& state) {
  Frame frame;
  frame.step = state.step;
  frame.time = state.time;
  frame.positions = state.positions;
  frame.previous = state.previous;
  frame.limits_off = state.limits_off;
  return frame;
}

}  // namespace

H5mdWriter::H5mdWriter(const std::filesystem::path& path, const Framework& framework,
                       const H5mdHeader& header, const H5mdOptions& options)
    : joint_count_(checked_joint_count(framework)),
      atoms_(framework.atoms()),
      options_(options),
      output_(path, options.overwrite),
      file_(output_.descriptor()) {
  open([&] { create(framework, header); });
}

H5mdWriter::H5mdWriter(const H5mdCheckpoint& from, const H5mdOptions& options)
    : joint_count_(checked_joint_count(from.framework)),
      atoms_(from.framework.atoms()),
      options_(options),
      output_(from.path),
      file_(output_.descriptor()),
      frames_(from.frames),
      committed_frames_(from.frames),
      last_step_(from.last_step),
      known_to_(from.last_step) {
  open([&] { go_on(from); });
}

template <class Make>
void H5mdWriter::open(Make make) {
  const Hdf5Session session;
  const FileSizeSignalHeld signal;
  try {
    try {
      make();
    } catch (const FileError& error) {
      fail(error.what());
    }
    if (file_.failure() != 0) fail("cannot write");
  } catch (...) {
    release();
    throw;
  }
}

void H5mdWriter::write_all(const Framework& framework, const H5mdHeader& header) {
  write_static_part(hdf5_, framework, header);
  if (!header.inputs) return;
  write_inputs(hdf5_, framework, header);
  if (!header.inputs->is_sample())
    checkpoint_ = std::make_unique<CheckpointWriter>(hdf5_, framework);
}

void H5mdWriter::write_part(const Framework& framework, const H5mdHeader& header) {
  part_.emplace(framework, options_.saved);
  write_static_part(hdf5_, part_->framework(), part_->header_of(header));
  write_saved_joints(hdf5_, part_->joints(), framework.joint_count());
}

void H5mdWriter::create(const Framework& framework, const H5mdHeader& header) {
  hdf5_ = create_hdf5(file_);
  const bool is_sample = header.inputs && header.inputs->is_sample();
  const FrameOrigin origin{is_sample, header.several_walkers, !framework.has_bars_only()};
  if (options_.saved.empty()) {
    write_all(framework, header);
    series_ = std::make_unique<FrameSeries>(hdf5_, framework, options_, origin);
  } else {
    write_part(framework, header);
    series_ = std::make_unique<FrameSeries>(hdf5_, part_->framework(), options_, origin);
  }
  checked(H5Fflush(hdf5_, H5F_SCOPE_GLOBAL), "flush the file");
  file_.write_last(series_->addresses(hdf5_));
}

void H5mdWriter::go_on(const H5mdCheckpoint& from) {
  const H5mdCheckpoint now = read_checkpoint(from.path, from.steps);
  if (now.number != from.number || now.frames != from.frames)
    throw FileError("another run has written to it meanwhile");
  hdf5_ = open_hdf5_to_write(file_);
  series_ =
      std::make_unique<FrameSeries>(hdf5_, from.framework, static_cast<std::uint64_t>(from.frames));
  file_.write_last(series_->addresses(hdf5_));
  file_.shrink();
  series_->cut();
  checked(H5Fflush(hdf5_, H5F_SCOPE_GLOBAL), "flush the file");
  rewrite_integer(hdf5_, from.is_sample() ? "/parameters/sample/frames" : "/parameters/run/steps",
                  from.steps);
  if (from.is_sample()) return;
  checkpoint_ = std::make_unique<CheckpointWriter>(hdf5_, from.framework, from.number);
}

H5mdWriter::~H5mdWriter() {
  try {
    close();
  } catch (const Error& error) {
    options_.log.warn(error.what());
  }
}

void H5mdWriter::record(const Frame& frame) {
  throw_if_failed();
  if (!hdf5_) throw FileError(path_text(path()) + ": is closed: no frame can be recorded");
  if (frame.step <= known_to_) return check_known_frame(frame);
  check_frame(frame);
  series_->add(part_ ? part_->shown(frame) : frame);
  last_step_ = frame.step;
  last_walker_ = frame.walker;
  ++frames_;
  if (is_checkpoint_due(frame)) return commit_checkpoint(frame);
  const double seconds = seconds_since(last_commit_);
  const bool is_much = series_->waiting_bytes() >= most_waiting_bytes;
  if (!output_.is_published() || seconds >= options_.flush_seconds ||
      (is_much && seconds >= least_seconds_of_a_commit && std::isfinite(options_.flush_seconds)))
    return commit();
  if (is_much) write_waiting();
}

/// The positions, nearly all of it, reach the file system when HDF5 is free for other threads.
void H5mdWriter::write_waiting() {
  file_.keep(series_->waiting_positions());
  write_to_file([&] { series_->write(); });
  const FileSizeSignalHeld signal;
  file_.write_kept();
  if (file_.failure() != 0) fail("cannot write");
}

void H5mdWriter::check_frame(const Frame& frame) const {
  const auto where = [&] {
    return path_text(path()) + ": frame of step " + std::to_string(frame.step);
  };
  if (frame.positions.size() != joint_count_)
    throw InputError(where() + " has " + std::to_string(frame.positions.size()) +
                     " positions for " + std::to_string(joint_count_) + " joints");
  if (frames_ > 0 && frame.walker <= last_walker_ && frame.step <= last_step_)
    throw InputError(where() + " comes after that of step " + std::to_string(last_step_));
  if (!std::isfinite(frame.time)) throw InputError(where() + " has a time that is not finite");
  for (std::size_t i = 0; i < joint_count_; ++i)
    if (!is_finite(frame.positions[i]))
      throw InputError(where() + ": position of " + joint_label(i) + " is not finite");
}

/// The steps between the checkpoint and the last frame are done again.
void H5mdWriter::check_known_frame(const Frame& frame) {
  if (frame.step != known_to_) return;
  const Hdf5Session session;
  if (!series_->last_is(frame.positions))
    throw FileError(path_text(path()) + ": the frame of step " + std::to_string(frame.step) +
                    " is not what the run gives now: it was written by another version of Pliant");
}

std::string H5mdWriter::joint_label(std::size_t joint) const {
  return atoms_ ? atoms_->label(joint) : "joint " + std::to_string(joint);
}

bool H5mdWriter::is_checkpoint_due(const Frame& frame) const {
  return checkpoint_ && !frame.previous.empty() &&
         (!output_.is_published() || seconds_since(last_checkpoint_) >= options_.flush_seconds);
}

void H5mdWriter::flush() {
  throw_if_failed();
  if (hdf5_) commit();
}

/// Both states are written, so that the same run leaves the same bytes however long it took.
void H5mdWriter::end_run(const State& state) {
  throw_if_failed();
  if (!hdf5_ || !checkpoint_ || frames_ == 0) return;
  for (int k = 0; k < 2; ++k) commit_checkpoint(frame_of(state));
}

void H5mdWriter::commit_checkpoint(const Frame& frame) {
  write_to_file([&] { checkpoint_->write(frame); });
  commit();
  last_checkpoint_ = Clock::now();
}

template <class Write>
void H5mdWriter::write_to_file(Write write) {
  const Hdf5Session session;
  const FileSizeSignalHeld signal;
  try {
    write();
  } catch (const FileError& error) {
    fail(error.what());
  }
  if (file_.failure() != 0) fail("cannot write");
}

void H5mdWriter::commit() {
  if (committed_frames_ < frames_ || checkpoint_) {
    write_to_file([&] {
      if (series_->waiting_frames() > 0) series_->write();
      checked(H5Fflush(hdf5_, H5F_SCOPE_GLOBAL), "flush the file");
    });
    if (!output_.is_published() && frames_ > 0) publish();
  }
  committed_frames_ = frames_;
  last_commit_ = Clock::now();
}

/// The file bears its name from its first frame on.
void H5mdWriter::publish() {
  try {
    output_.publish();
  } catch (const FileError& error) {
    failure_ = error.what();
    release();
    throw;
  }
}

/// The system's reason, where there is one, says more than what HDF5 made of it.
void H5mdWriter::fail(const std::string& reason) {
  failure_ = path_text(output_.target()) + ": " +
             (file_.failure() == 0 ? reason : "cannot write: " + error_words(file_.failure()));
  if (committed_frames_ > 0)
    failure_ += "; the file holds the first " + std::to_string(committed_frames_) + " frames";
  release();
  throw FileError(failure_);
}

void H5mdWriter::throw_if_failed() const {
  if (!failure_.empty()) throw FileError(failure_);
}

void H5mdWriter::close() {
  if (!hdf5_) return;
  commit();
  const FileSizeSignalHeld signal;
  release();
  if (file_.failure() != 0) fail("cannot write");
}

/// HDF5 holds nothing of the file afterwards, so that neither it nor its exit handler can fail.
void H5mdWriter::release() {
  file_.write_kept();
  {
    const Hdf5Session session;
    series_.reset();
    checkpoint_.reset();
    hdf5_.reset();
  }
  file_.trim();
  file_.flush();
  output_.close();
}

}  // namespace pliant
