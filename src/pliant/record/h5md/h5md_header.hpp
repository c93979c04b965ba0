// SPDX-License-Identifier: MIT
// Options of recording, and the contents of an H5MD file besides frames.
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
  /// positions are rounded by at most half of this (Angstrom) so that they compress well, and
  /// compressed (shuffled, gzip 1); 0: neither. Observables and checkpoints use the unrounded
  /// positions
  double precision = 0.0;
  /// Joints to record, ascending; empty: all. The file then has only these, with the bars, bonds
  /// and limits among them, but without sterics and checkpoints. Observables are those of all
  /// joints, except for counts of contacts.
  std::vector<Joint> saved = {};
  bool overwrite = false;  ///< replace an existing file once the new one has a frame
  /// interval between commits (s); 0: after each frame; infinity: only the first and the last, so
  /// that equal frames give equal bytes
  double flush_seconds = 1.0;
  Log log = {};  ///< where warnings go
};

/// What of them a file tells, by paths below /parameters. `save`: the selection of the joints.
inline std::vector<NamedParameter> parameters_of(const H5mdOptions& options,
                                                 const std::string& save) {
  return {{"record/save", save}, {"record/precision", options.precision}};
}

/// A bond of the atom table: chemistry, which need not be a bar.
struct RecordedBond {
  Joint a = 0, b = 0;
  std::uint8_t origin = 0;  ///< index into the names of origins
  std::uint8_t order = 0;   ///< 1, 2, 3; 4 aromatic; 0 not known

  friend bool operator==(const RecordedBond&, const RecordedBond&) = default;
};

/// The inputs of a run or a sample besides framework and parameters, recorded so that it can
/// continue from the file.
struct RunInputs {
  std::vector<Vec3> start = {};                     ///< (N) Angstrom; or empty if not kept
  std::vector<Joint> replay_joints = {};            ///< (R) joints of a replay
  std::vector<Vec3> replay_forces = {};             ///< (R) kJ/(mol Angstrom)
  std::vector<std::int64_t> replay_counts = {};     ///< (S) forces of each step; empty: one in each
  std::vector<Vec3> guide_rock = {};                ///< (N) Angstrom, or none
  std::int64_t guide_period = 0;                    ///< steps; 0: no guide
  std::vector<Joint> pull_joints = {};              ///< (P) joints of all groups, one after another
  std::vector<std::uint32_t> pull_groups = {};      ///< (P) group of each, from 0
  std::vector<Vec3> pull_to = {};                   ///< (K) Angstrom
  std::vector<Joint> pair_joints = {};              ///< (P) joints of all groups, one after another
  std::vector<std::uint32_t> pair_groups = {};      ///< (P) 2 k and 2 k + 1: the groups of pair k
  std::vector<double> pair_least = {};              ///< (K) Angstrom
  std::vector<double> pair_most = {};               ///< (K) Angstrom
  std::vector<BarIndex> ordering_bars = {};         ///< (V) of a given ordering
  std::vector<Joint> ordering_near = {};            ///< (V)
  std::vector<std::uint8_t> ordering_is_tree = {};  ///< (V)
  std::vector<Vec3> node_positions = {};            ///< (M) Angstrom, nodes of a sample's network
  std::vector<std::uint32_t> node_chains = {};      ///< (M)
  std::vector<std::int64_t> node_of_joint = {};     ///< (N) -1: none

  /// A sample needs no state: it continues after its last frame.
  bool is_sample() const { return !node_positions.empty(); }
};

/// Contents of a file besides framework and frames.
struct H5mdHeader {
  std::vector<RecordedBond> bonds;
  std::vector<std::string> bond_origin_names;  ///< what RecordedBond::origin means; may be empty
  std::vector<double> masses;                  ///< (N) u; empty: the framework's, 1 if pinned
  std::string creator = "pliant";
  std::string creator_version = "";
  std::string author = "unknown";
  std::vector<NamedParameter> parameters;  ///< all options of the run, with distinct paths
  std::optional<RunInputs> inputs = {};  ///< needed for a run or a sample to continue from the file
  /// frames are of one walker after another (Frame::walker), each with its own steps; not allowed
  /// with inputs
  bool several_walkers = false;
};

}  // namespace pliant
