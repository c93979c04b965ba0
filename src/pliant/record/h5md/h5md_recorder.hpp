// SPDX-License-Identifier: MIT
// H5MD recorder (trajectory writer, reporter): writes frames to an H5MD 1.1 file that MDAnalysis,
// h5py and every other HDF5 program can open at any moment, even after the writer was killed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

struct H5mdCheckpoint;
class H5mdWriter;

/// Writes frames to one file, which holds the group /particles/trajectory.
///
/// Frames are gathered in memory and committed together: the first at once, then about every
/// `flush_seconds`, up to five times a second where some megabytes have gathered, on flush(), on
/// close() and by the destructor. Whenever the writer is killed, and while it lives, the file can
/// be opened and has every committed frame.
///
/// If the header has the inputs of a run, a checkpoint is committed with the first frame, then
/// about every `flush_seconds`, and by end_run(). A sample continues after its last frame.
///
/// A failed write (disk full, file size limit) ends the recording: the frames committed before
/// remain readable, later calls throw the same error, and the destructor does nothing.
class H5mdRecorder {
 public:
  /// Creates the file under a temporary name (".NAME.partial"), and renames it with the first
  /// frame; until then an existing file is unchanged. Throws FileError (with the system's reason)
  /// when the directory is missing, the file exists and may not be overwritten, is not a regular
  /// file, or is being written by another recorder (named by its process id); OptionError for bad
  /// options or parameters.
  H5mdRecorder(const std::filesystem::path& path, const Framework& framework,
               const H5mdHeader& header = {}, const H5mdOptions& options = {});
  /// Continues a file at the frame where read_checkpoint() ends it. Frames up to there, which the
  /// run shows again, are not recorded twice; the last must have the same bits as in the file. The
  /// options `saved` and `overwrite` are ignored. Throws FileError when the file cannot be written,
  /// is being written, or has been since it was read.
  explicit H5mdRecorder(const H5mdCheckpoint& from, const H5mdOptions& options = {});
  ~H5mdRecorder();
  H5mdRecorder(H5mdRecorder&&) noexcept;
  H5mdRecorder& operator=(H5mdRecorder&&) noexcept;

  /// Adds one frame. Throws InputError when the number of positions is not that of the joints, a
  /// position (naming the joint) or the time is not finite, or the step of a walker does not
  /// increase; FileError when the frame cannot be written, or the recorder is closed.
  void record(const Frame& frame);

  /// Commits the frames and the final state of the run, from which it can continue. Has no effect
  /// without inputs in the header, or before the first frame.
  void end_run(const State& state);

  /// Commits all recorded frames, which then survive the end of this process.
  void flush();

  /// Commits and closes the file; closing or flushing it again does nothing. Throws FileError; the
  /// destructor only logs it.
  void close();

  std::int64_t frames() const;            ///< recorded frames
  std::int64_t committed_frames() const;  ///< recorded frames that are certainly in the file
  const std::filesystem::path& path() const;

 private:
  std::unique_ptr<H5mdWriter> writer_;
};

}  // namespace pliant
