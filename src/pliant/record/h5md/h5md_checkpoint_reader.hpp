// SPDX-License-Identifier: MIT
// A run or a sample in an H5MD file, as it can go on: its framework, its state and what it was
// given.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

/// A run in a file, as it can go on; or a sample, whose steps are its frames and which has no
/// state.
struct H5mdCheckpoint {
  std::filesystem::path path;
  State state;                 ///< to step on from
  std::int64_t number = 0;     ///< of the checkpoint; 0 of a sample
  std::int64_t began = 0;      ///< the step of the first frame; of a sample, that was asked for
  std::int64_t frames = 0;     ///< that stay; a last one that is none of every N-th does not
  std::int64_t last_step = 0;  ///< of them; the state's is a later or an earlier one
  std::int64_t steps = 0;      ///< that the run is to do in all
  std::int64_t done = 0;       ///< steps of it that frames or the state show
  Framework framework{FrameworkParts{}};
  std::vector<NamedParameter> parameters;
  RunInputs inputs;

  bool is_sample() const { return inputs.is_sample(); }
};

/// Reads what a run or a sample goes on from. `steps`: how many it is to do in all; default: as it
/// was to.
/// Throws FileError and InputError as H5mdReader does; InputError where the file has no checkpoint.
H5mdCheckpoint read_checkpoint(const std::filesystem::path& path,
                               std::optional<std::int64_t> steps = {}, const Log& log = {});

}  // namespace pliant
