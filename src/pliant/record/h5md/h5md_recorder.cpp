// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_recorder.hpp"

#include <hdf5.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>

#include "pliant/base/error.hpp"
#include "pliant/record/h5md/h5md_frames.hpp"
#include "pliant/record/h5md/h5md_static.hpp"
#include "pliant/record/hdf5/committed_driver.hpp"
#include "pliant/record/hdf5/hdf5_session.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {
namespace {

using Clock = std::chrono::steady_clock;

// Frames that wait in memory are committed when they take this many bytes: few enough to stay in
// the processor's cache, many enough that the fifty microseconds of a commit matter little.
constexpr std::size_t most_waiting_bytes = std::size_t{1} << 20;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

const H5mdOptions& checked_options(const H5mdOptions& options) {
  if (!(options.flush_seconds >= 0.0))
    throw OptionError("H5mdOptions::flush_seconds = " + std::to_string(options.flush_seconds) +
                      ": must be 0 or more");
  return options;
}

/// False for what is not a number, too.
bool is_within(Vec3 p, double most) {
  return std::abs(p.x) <= most && std::abs(p.y) <= most && std::abs(p.z) <= most;
}

std::size_t checked_joint_count(const Framework& framework) {
  if (framework.joint_count() == 0)
    throw InputError("a framework without joints has no trajectory");
  return framework.joint_count();
}

/// A write beyond the file size limit (RLIMIT_FSIZE) raises SIGXFSZ, which kills the process. The
/// signal goes to the thread that writes: here it waits until it is taken away.
class FileSizeSignalHeld {
 public:
  FileSizeSignalHeld() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  }
  ~FileSizeSignalHeld() {
    if (sigismember(&before_, SIGXFSZ) == 0) {
      constexpr timespec at_once{0, 0};
      while (sigtimedwait(&signals_, nullptr, &at_once) == SIGXFSZ) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  FileSizeSignalHeld(const FileSizeSignalHeld&) = delete;
  FileSizeSignalHeld& operator=(const FileSizeSignalHeld&) = delete;

 private:
  sigset_t signals_{}, before_{};
};

}  // namespace

class H5mdRecorder::Writer {
 public:
  Writer(const std::filesystem::path& path, const Framework& framework, const H5mdHeader& header,
         const H5mdOptions& options);
  ~Writer();

  void record(const Frame& frame);
  void flush();
  void close();

  std::int64_t frames() const { return frames_; }
  std::int64_t committed_frames() const { return committed_frames_; }
  const std::filesystem::path& path() const { return output_.target(); }

 private:
  void create(const Framework& framework, const H5mdHeader& header);
  void check_frame(const Frame& frame) const;
  std::string joint_label(std::size_t joint) const;
  void commit();
  void write_waiting_frames();
  [[noreturn]] void fail(const std::string& reason);
  void throw_if_failed() const;
  void release();

  const std::size_t joint_count_;
  const std::shared_ptr<const AtomTable> atoms_;
  const H5mdOptions options_;
  // Destroyed from the last to the first: HDF5 lets go of the file before it is closed.
  OutputFile output_;
  CommittedFile file_;
  Hid hdf5_;
  std::unique_ptr<FrameSeries> series_;
  std::int64_t frames_ = 0, committed_frames_ = 0;
  std::int64_t last_step_ = std::numeric_limits<std::int64_t>::min();
  Clock::time_point last_commit_ = Clock::now();
  std::string failure_;  // what all later calls throw
};

H5mdRecorder::Writer::Writer(const std::filesystem::path& path, const Framework& framework,
                             const H5mdHeader& header, const H5mdOptions& options)
    : joint_count_(checked_joint_count(framework)),
      atoms_(framework.atoms()),
      options_(options),
      output_(path, options.overwrite),
      file_(output_.descriptor()) {
  const Hdf5Session session;
  const FileSizeSignalHeld signal;
  try {
    create(framework, header);
    output_.publish();
  } catch (...) {
    release();
    throw;
  }
}

void H5mdRecorder::Writer::create(const Framework& framework, const H5mdHeader& header) {
  try {
    hdf5_ = create_hdf5(file_);
    write_static_part(hdf5_, framework, header);
    series_ = std::make_unique<FrameSeries>(hdf5_, framework, options_);
    checked(H5Fflush(hdf5_, H5F_SCOPE_GLOBAL), "flush the file");
    file_.write_last(series_->addresses(hdf5_));
  } catch (const FileError& error) {
    fail(error.what());
  }
  if (file_.failure() != 0) fail("cannot write");
}

H5mdRecorder::Writer::~Writer() {
  try {
    close();
  } catch (const Error& error) {
    options_.log.warn(error.what());
  }
}

void H5mdRecorder::Writer::record(const Frame& frame) {
  throw_if_failed();
  if (!hdf5_) throw FileError(path().string() + ": is closed: no frame can be recorded");
  check_frame(frame);
  series_->add(frame);
  last_step_ = frame.step;
  ++frames_;
  if (series_->waiting_bytes() >= most_waiting_bytes ||
      seconds_since(last_commit_) >= options_.flush_seconds)
    commit();
}

void H5mdRecorder::Writer::check_frame(const Frame& frame) const {
  const auto where = [&] {
    return path().string() + ": frame of step " + std::to_string(frame.step);
  };
  if (frame.positions.size() != joint_count_)
    throw InputError(where() + " has " + std::to_string(frame.positions.size()) +
                     " positions for " + std::to_string(joint_count_) + " joints");
  if (frames_ > 0 && frame.step <= last_step_)
    throw InputError(where() + " comes after that of step " + std::to_string(last_step_));
  if (!std::isfinite(frame.time)) throw InputError(where() + " has a time that is not finite");
  const double most = options_.single ? double(std::numeric_limits<float>::max())
                                      : std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < joint_count_; ++i)
    if (!is_within(frame.positions[i], most))
      throw InputError(where() + ": position of " + joint_label(i) + " is not finite");
}

std::string H5mdRecorder::Writer::joint_label(std::size_t joint) const {
  return atoms_ ? atoms_->label(joint) : "joint " + std::to_string(joint);
}

void H5mdRecorder::Writer::flush() {
  throw_if_failed();
  if (hdf5_) commit();
}

void H5mdRecorder::Writer::commit() {
  const Hdf5Session session;
  const FileSizeSignalHeld signal;
  try {
    write_waiting_frames();
  } catch (const FileError& error) {
    fail(error.what());
  }
  if (file_.failure() != 0) fail("cannot write");
  committed_frames_ = frames_;
  last_commit_ = Clock::now();
}

void H5mdRecorder::Writer::write_waiting_frames() {
  if (series_->waiting_frames() == 0) return;
  series_->write();
  checked(H5Fflush(hdf5_, H5F_SCOPE_GLOBAL), "flush the file");
}

/// The system's reason, where there is one, says more than what HDF5 made of it.
void H5mdRecorder::Writer::fail(const std::string& reason) {
  failure_ =
      output_.target().string() + ": " +
      (file_.failure() == 0 ? reason
                            : "cannot write: " + std::string(std::strerror(file_.failure())));
  if (committed_frames_ > 0)
    failure_ += "; the file holds the first " + std::to_string(committed_frames_) + " frames";
  release();
  throw FileError(failure_);
}

void H5mdRecorder::Writer::throw_if_failed() const {
  if (!failure_.empty()) throw FileError(failure_);
}

void H5mdRecorder::Writer::close() {
  if (!hdf5_) return;
  commit();
  const Hdf5Session session;
  const FileSizeSignalHeld signal;
  release();
  if (file_.failure() != 0) fail("cannot write");
}

/// HDF5 holds nothing of the file afterwards, so that neither it nor its exit handler can fail.
void H5mdRecorder::Writer::release() {
  series_.reset();
  hdf5_.reset();
  output_.close();
}

H5mdRecorder::H5mdRecorder(const std::filesystem::path& path, const Framework& framework,
                           const H5mdHeader& header, const H5mdOptions& options)
    : writer_(std::make_unique<Writer>(path, framework, header, checked_options(options))) {}
H5mdRecorder::~H5mdRecorder() = default;
H5mdRecorder::H5mdRecorder(H5mdRecorder&&) noexcept = default;
H5mdRecorder& H5mdRecorder::operator=(H5mdRecorder&&) noexcept = default;

void H5mdRecorder::record(const Frame& frame) { writer_->record(frame); }
void H5mdRecorder::flush() { writer_->flush(); }
void H5mdRecorder::close() { writer_->close(); }
std::int64_t H5mdRecorder::frames() const { return writer_->frames(); }
std::int64_t H5mdRecorder::committed_frames() const { return writer_->committed_frames(); }
const std::filesystem::path& H5mdRecorder::path() const { return writer_->path(); }

}  // namespace pliant
