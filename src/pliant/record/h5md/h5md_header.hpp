// SPDX-License-Identifier: MIT
// What an H5MD file is asked to hold besides frames, and how it is written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/base/parameter.hpp"
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

/// What of them a file tells, by paths below /parameters. `save`: the selection of the joints.
inline std::vector<NamedParameter> parameters_of(const H5mdOptions& options,
                                                 const std::string& save) {
  return {{"record/single", options.single},
          {"record/compress", options.compress},
          {"record/save", save},
          {"record/precision", options.precision}};
}

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

}  // namespace pliant
