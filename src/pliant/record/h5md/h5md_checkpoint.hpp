// SPDX-License-Identifier: MIT
// Checkpoint: what a run or a sample needs to continue from an H5MD file, bit by bit.
//
// Below /parameters/checkpoint:
//   state (2, 5 + 6 N + L)  two states, written alternately, so that one is always complete:
//     number of the checkpoint (the larger is the later), step, time (ps), two halves of a digest,
//     positions (3 N), previous positions (3 N), limits that are off (L, 1 for off); not of samples
//   mass (N) u, drawn (N, 3)   where /particles does not have their exact bits
//   start (N, 3)               where several walkers do not start from the drawn positions
//   replay_joint (R), replay_force (R, 3) kJ/(mol Angstrom)   in a replay
//   replay_count (S)           in a replay whose steps do not have one force each
//   ordering_bar, ordering_near, ordering_is_tree (V)         if an ordering was given
//   node_position (M, 3), node_chain (M), node_of_joint (N, -1: none)   network of a sample
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pliant/framework/frame.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/record/h5md/h5md_header.hpp"
#include "pliant/record/h5md/h5md_static.hpp"
#include "pliant/record/hdf5/hdf5_session.hpp"

namespace pliant {

/// Layout of a row of `state`.
namespace checkpoint {
inline const std::string group = h5md::checkpoint;
inline const std::string state = group + "/state";
inline const std::string nodes = group + "/node_position";
inline constexpr std::size_t number_column = 0;
inline constexpr std::size_t step_column = 1;
inline constexpr std::size_t time_column = 2;
inline constexpr std::size_t digest_column = 3;  // two
inline constexpr std::size_t head_columns = 5;
inline constexpr std::size_t state_count = 2;

/// Number of columns of a row.
std::size_t columns_of(const Framework& framework);

/// Digest of all columns except the digest itself; it shows whether a state was written completely.
std::array<double, 2> digest_of(std::span<const double> row);
}  // namespace checkpoint

/// Makes the group in the new HDF5 file `file` (hid_t) and writes header.inputs. Throws FileError.
/// Callers hold an Hdf5Session.
void write_inputs(std::int64_t file, const Framework& framework, const H5mdHeader& header);

/// The states of a file that is being written. Callers hold an Hdf5Session.
class CheckpointWriter {
 public:
  /// Makes both states in the new HDF5 file `file` (hid_t), which has inputs. Throws FileError.
  CheckpointWriter(std::int64_t file, const Framework& framework);
  /// Opens the states, to continue after the checkpoint of this number. Throws FileError.
  CheckpointWriter(std::int64_t file, const Framework& framework, std::int64_t number);

  /// Writes the state after this frame over the older of the two states. The frame must be
  /// committed before the next state is written. Throws FileError.
  void write(const Frame& frame);

 private:
  Hid dataset_;
  std::size_t joint_count_;
  std::int64_t number_ = 0;  ///< of the last state that was written; 0 if none was
  std::vector<double> row_;
};

}  // namespace pliant
