// SPDX-License-Identifier: MIT
// Who looks at a run and acts in it, besides its files.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "pliant/run/run.hpp"

namespace pliant {

/// Largest displacement of an atom by a client in a step, Angstrom, which bars can still follow.
inline constexpr double longest_live_step = 0.2;

/// Members that are empty are not called.
struct RunWatch {
  /// Called before a walker begins, when its files are there.
  std::function<std::vector<Observer>(std::int64_t walker)> observers_of = {};
  std::function<void(std::int64_t steps)> on_steps = {};  ///< done by all walkers; may overlap not
  std::function<bool()> should_stop = {};                 ///< asked by all threads
  std::function<void(std::int64_t walker, const State& last)> on_end = {};  ///< before files close
  std::vector<std::shared_ptr<Pusher>> hands = {};                          ///< of clients
  Onlooker onlooker = {};                                                   ///< of clients
  std::function<bool()> was_pulled = {};  ///< by clients: else a force file of theirs is not kept

  bool stops() const { return should_stop && should_stop(); }
};

}  // namespace pliant
