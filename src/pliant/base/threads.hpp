// SPDX-License-Identifier: MIT
// Threads where the system has them. WebAssembly (WASI) has none: there one call does all the work.
#pragma once

#include <cstddef>
#include <mutex>

#ifndef __wasi__
#include <condition_variable>
#include <thread>
#include <vector>
#endif

namespace pliant {

#ifdef __wasi__

/// A mutex for a program with one thread: does nothing.
struct Mutex {
  void lock() {}
  void unlock() {}
};

/// What one thread waits for holds already.
struct Condition {
  template <class Lock, class Holds>
  void wait(Lock&, const Holds&) {}
  void notify_all() {}
};

template <class Work>
void run_in_threads(std::size_t, const Work& work) {
  work(std::size_t{0});
}

#else

using Mutex = std::mutex;
using Condition = std::condition_variable;

/// Calls work(0) in this thread and work(1) ... work(count - 1) in others, and waits for them. The
/// calls take their tasks from a shared queue, so that a single call can do all of them. `work`
/// must not throw.
template <class Work>
void run_in_threads(std::size_t count, const Work& work) {
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < count; ++k) others.emplace_back([&work, k] { work(k); });
  work(std::size_t{0});
}

#endif

}  // namespace pliant
