// SPDX-License-Identifier: MIT
#include "pliant/run/run_options.hpp"

namespace pliant {

std::int64_t replayed_steps(const RunOptions& options) {
  const bool has_counts = !options.replay_counts.empty();
  return static_cast<std::int64_t>(has_counts ? options.replay_counts.size()
                                              : options.replay.size());
}

}  // namespace pliant
