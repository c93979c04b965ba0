// SPDX-License-Identifier: MIT
// Which walkers a run has, and the files that it goes by.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pliant/base/option_fields.hpp"

namespace pliant {

struct WalkersAsked {
  std::int64_t walkers = 1;   ///< from `first` on
  std::string shard;          ///< "FIRST..LAST", numbers of walkers, in place of `walkers`; or ""
  std::int64_t first = 0;     ///< no row: of the shard
  bool one_file = false;      ///< all frames go into one trajectory, one walker after another
  std::int64_t threads = 0;   ///< 0: one for each core
  std::string ordering;       ///< ordering file that replaces a technique's ordering; "": none
  std::string forces;         ///< force file to replay; "": none
  std::string record_forces;  ///< force file to write; "": none

  /// Whether there are several walkers, or a shard of several.
  bool are_several() const { return walkers != 1 || !shard.empty(); }
};

/// The table of these options; recorded below "run".
std::span<const OptionField<WalkersAsked>> walkers_fields();

/// Sets the numbers of the walkers from the shard. Throws OptionError.
void number_walkers(WalkersAsked& asked);

}  // namespace pliant
