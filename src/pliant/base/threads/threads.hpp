// SPDX-License-Identifier: MIT
// Threads where the system has them. WebAssembly (WASI) has none: there one call does all the work.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <vector>

#ifndef __wasi__
#include <condition_variable>
#include <thread>
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

inline unsigned all_processors() { return 1; }

template <class Work>
void run_in_threads(std::size_t, const Work& work) {
  work(std::size_t{0});
}

#else

using Mutex = std::mutex;
using Condition = std::condition_variable;

/// How many threads run at the same time; 1 where the system does not say.
inline unsigned all_processors() { return std::max(1U, std::thread::hardware_concurrency()); }

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

/// Calls work(k) for each k < tasks, on `threads` threads; throws the first that one of them threw,
/// once all have ended.
template <class Work>
void for_each_in_threads(std::size_t threads, std::size_t tasks, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> thrown(tasks);
  run_in_threads(std::min(threads, tasks), [&](std::size_t) {
    for (std::size_t k = next++; k < tasks; k = next++) try {
        work(k);
      } catch (...) {
        thrown[k] = std::current_exception();
      }
  });
  for (const std::exception_ptr& one : thrown)
    if (one) std::rethrow_exception(one);
}

}  // namespace pliant
