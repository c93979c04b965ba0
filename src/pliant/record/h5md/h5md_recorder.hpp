// SPDX-License-Identifier: MIT
// H5MD recorder (trajectory writer, reporter): writes frames to an H5MD 1.1 file that MDAnalysis,
// h5py and every other HDF5 program open, at any moment and after any death of the writer.
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
/// close() and by the destructor. The order of writes within a commit is such that the file opens
/// after the writer was killed at any moment, with every frame committed before, and while the
/// writer lives.
///
/// Where the header has the inputs of a run, what the run can go on from (a checkpoint) is
/// committed with the first frame, then about every `flush_seconds`, and by end_run(). A sample
/// goes on after its last frame.
///
/// A failed write (disk full, file size limit) ends the recording: the frames committed before it
/// stay readable, later calls throw the same error, and the destructor does nothing.
class H5mdRecorder {
 public:
  /// Creates the file under a temporary name (".NAME.partial"). It takes its name with its first
  /// frame; until then an existing file is as it was.
  /// Throws FileError (with the system's reason) when the directory is missing, the file exists
  /// and may not be overwritten, is not a regular file, or is being written by another recorder
  /// (named by its process id); OptionError on bad options or parameters.
  H5mdRecorder(const std::filesystem::path& path, const Framework& framework,
               const H5mdHeader& header = {}, const H5mdOptions& options = {});
  /// Goes on in a file where read_checkpoint() says that it ends. Frames up to there, which the run
  /// shows again, are not recorded a second time; the last must have the bits that the file has. Of
  /// the options, `single`, `compress`, `saved` and `overwrite` are not looked at. Throws FileError
  /// when the file cannot be written, or is being written, or has been since it was read.
  explicit H5mdRecorder(const H5mdCheckpoint& from, const H5mdOptions& options = {});
  ~H5mdRecorder();
  H5mdRecorder(H5mdRecorder&&) noexcept;
  H5mdRecorder& operator=(H5mdRecorder&&) noexcept;

  /// Adds one frame. Throws InputError when the number of positions is not that of the joints,
  /// when a position (naming the joint) or the time is not finite, or when the step does not
  /// increase (of the same walker, where there are several); FileError when it cannot be written,
  /// or the recorder is closed.
  void record(const Frame& frame);

  /// The run of the frames ends in this state: commits both, so that it can go on from there. Only
  /// where the header has inputs, and a frame was recorded.
  void end_run(const State& state);

  /// Commits what was recorded: it survives whatever happens to this process.
  void flush();

  /// Commits and closes the file; closing or flushing it again does nothing. Throws FileError,
  /// which the destructor would only log.
  void close();

  std::int64_t frames() const;            ///< recorded
  std::int64_t committed_frames() const;  ///< recorded, and certain to be in the file
  const std::filesystem::path& path() const;

 private:
  std::unique_ptr<H5mdWriter> writer_;
};

}  // namespace pliant
