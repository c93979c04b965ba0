// SPDX-License-Identifier: MIT
// H5MD recorder (trajectory writer, reporter): writes frames to an H5MD 1.1 file that MDAnalysis,
// h5py and every other HDF5 program open, at any moment and after any death of the writer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/base/parameter.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// How to record.
struct H5mdOptions {
  bool single = false;     ///< positions as 32-bit floats: half the size, 1e-7 relative
  bool compress = false;   ///< shuffle and gzip 1: about 0.8 of the size, ten times the time
  double precision = 0.0;  ///< positions are rounded by half of this at most (Angstrom), which
                           ///< makes them compress well, and compressed; 0: as they are. What is
                           ///< told of a frame, and the checkpoint, are those before it
  /// Joints to record, ascending; empty: all. The file is then one of these alone, with the bars,
  /// bonds and limits among them, without sterics, and no run goes on from it. Observables are of
  /// all joints, but for counts of contacts.
  std::vector<Joint> saved = {};
  bool overwrite = false;      ///< replace an existing file once the new one has a frame
  double flush_seconds = 1.0;  ///< frames are committed to the file this often (s); 0: each frame;
                               ///< infinity: the first and the last only, so that the same frames
                               ///< give the same bytes, however long they took
  bool durable = false;        ///< a commit waits for the disk (fsync): it survives a power cut
  Log log = {};                ///< where warnings go
};

/// A bond of the atom table: chemistry, which need not be a bar.
struct RecordedBond {
  Joint a = 0, b = 0;
  std::uint8_t origin = 0;  ///< index into the names of origins
  std::uint8_t order = 0;   ///< 1, 2, 3; 4 aromatic; 0 not known

  friend bool operator==(const RecordedBond&, const RecordedBond&) = default;
};

/// What a run, or a sample, is given besides its framework and its parameters. It is recorded so
/// that it can go on from the file.
struct RunInputs {
  std::vector<Vec3> start = {};                     ///< (N) Angstrom; or empty: not kept
  std::vector<Joint> replay_joints = {};            ///< (R) of a replay
  std::vector<Vec3> replay_forces = {};             ///< (R) kJ/(mol Angstrom)
  std::vector<std::int64_t> replay_counts = {};     ///< (S) of each step; or none: one force each
  std::vector<Vec3> guide_rock = {};                ///< (N) Angstrom, or none
  std::int64_t guide_period = 0;                    ///< steps; 0: no guide
  std::vector<Joint> pull_joints = {};              ///< (P) of all groups, one after another
  std::vector<std::uint32_t> pull_groups = {};      ///< (P) from 0
  std::vector<Vec3> pull_to = {};                   ///< (K) Angstrom
  std::vector<Joint> pair_joints = {};              ///< (P) of all groups, one after another
  std::vector<std::uint32_t> pair_groups = {};      ///< (P) 2 k and 2 k + 1: the groups of pair k
  std::vector<double> pair_least = {};              ///< (K) Angstrom
  std::vector<double> pair_most = {};               ///< (K) Angstrom
  std::vector<BarIndex> ordering_bars = {};         ///< (V) of an ordering that was given
  std::vector<Joint> ordering_near = {};            ///< (V)
  std::vector<std::uint8_t> ordering_is_tree = {};  ///< (V)
  std::vector<Vec3> node_positions = {};            ///< (M) Angstrom, of a sample's network
  std::vector<std::uint32_t> node_chains = {};      ///< (M)
  std::vector<std::int64_t> node_of_joint = {};     ///< (N) -1: none

  /// Frames of a sample need no state: they go on after the last one.
  bool is_sample() const { return !node_positions.empty(); }
};

struct H5mdCheckpoint;
class H5mdWriter;

/// What a file says in addition to the framework and the frames.
struct H5mdHeader {
  std::vector<RecordedBond> bonds;
  std::vector<std::string> bond_origin_names;  ///< what RecordedBond::origin means; may be empty
  std::vector<double> masses;                  ///< (N) u; empty: the framework's, 1 if pinned
  std::string creator = "pliant";
  std::string creator_version = "";
  std::string author = "unknown";
  std::vector<NamedParameter> parameters;  ///< every option of the run; no path twice
  std::optional<RunInputs> inputs = {};    ///< with them a run or sample can go on from the file
  bool several_walkers = false;  ///< frames are of one walker after another (Frame::walker), the
                                 ///< steps of each beginning anew; goes without inputs
};

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
