// SPDX-License-Identifier: MIT
// Threads, where the system has them: in WebAssembly (WASI) there is one, and all is done by it.
#pragma once

#include <cstddef>
#include <mutex>

#ifndef __wasi__
#include <thread>
#include <vector>
#endif

namespace pliant {

#ifdef __wasi__

/// Nobody to wait for.
struct Mutex {
  void lock() {}
  void unlock() {}
};

template <class Work>
void run_in_threads(std::size_t, const Work& work) {
  work(std::size_t{0});
}

#else

using Mutex = std::mutex;

/// Calls work(0) in this thread and work(1) ... work(count - 1) in others, and waits for them. Work
/// takes what is to be done from a place that all share, so that a single call does all of it; it
/// must not throw.
template <class Work>
void run_in_threads(std::size_t count, const Work& work) {
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < count; ++k) others.emplace_back([&work, k] { work(k); });
  work(std::size_t{0});
}

#endif

}  // namespace pliant
