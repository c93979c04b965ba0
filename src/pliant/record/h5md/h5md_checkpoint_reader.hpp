// SPDX-License-Identifier: MIT
// Reads a run or a sample from an H5MD file so that it can continue: framework, state and inputs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

/// A run or a sample that can continue from a file. The steps of a sample are its frames, and it
/// has no state.
struct H5mdCheckpoint {
  std::filesystem::path path;
  State state;              ///< the state to continue from
  std::int64_t number = 0;  ///< of the checkpoint; 0 in a sample
  std::int64_t began = 0;   ///< step of the first frame; in a sample, of the first frame asked for
  std::int64_t frames = 0;  ///< frames that are kept; the last is dropped unless it is an N-th one
  /// step of the last of these frames; may differ from that of the state
  std::int64_t last_step = 0;
  std::int64_t steps = 0;  ///< total number of steps of the run
  std::int64_t done = 0;   ///< steps of the run that the frames or the state show
  Framework framework{FrameworkParts{}};
  std::vector<NamedParameter> parameters;
  RunInputs inputs;

  bool is_sample() const { return inputs.is_sample(); }
};

/// Reads what a run or a sample continues from. `steps`: the total number of steps; as recorded by
/// default. Throws FileError and InputError as H5mdReader does; InputError where the file has no
/// checkpoint.
H5mdCheckpoint read_checkpoint(const std::filesystem::path& path,
                               std::optional<std::int64_t> steps = {}, const Log& log = {});

}  // namespace pliant
