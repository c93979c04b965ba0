// SPDX-License-Identifier: MIT
// Work on several threads, whose results are shown on one of them, in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "pliant/base/threads/threads.hpp"

namespace pliant {

/// Makes shares of work on `threads` threads, and shows them in the order in which they were taken,
/// on the thread that calls run(), which makes shares, too, while there is nothing to show. No
/// thread waits for another unless `most_waiting` shares are taken that were not shown.
///
/// Share is default-constructible. Shares that were shown are used again, with their memory.
template <class Share>
class OrderedWork {
 public:
  OrderedWork(std::size_t threads, std::size_t most_waiting)
      : threads_(threads), most_waiting_(std::max(threads, most_waiting)) {}

  /// take(share, thread) says what a share is to hold, one call at a time, and false if nothing is
  /// left; make(share, thread) makes it; show(share) returns false to stop: what is made by then,
  /// and not shown, is left out. What one of them throws is thrown once all threads have ended.
  template <class Take, class Make, class Show>
  void run(const Take& take, const Make& make, const Show& show) {
    run_in_threads(threads_, [&](std::size_t thread) {
      try {
        if (thread == 0) {
          lead(take, make, show);
        } else {
          help(take, make, thread);
        }
      } catch (...) {
        fail();
      }
    });
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  using Lock = std::unique_lock<Mutex>;
  struct Taken {
    Share share;
    bool is_made = false;
  };

  template <class Take, class Make, class Show>
  void lead(const Take& take, const Make& make, const Show& show) {
    Lock hold(mutex_);
    while (!is_over_) {
      if (is_next_made()) {
        if (!show_next(show, hold)) is_over_ = true;  // another thread may have failed meanwhile
        changed_.notify_all();
      } else if (Taken* taken = next(take, 0)) {
        make_one(*taken, make, 0, hold);
      } else if (waiting_.empty()) {
        is_over_ = true;
      } else {
        changed_.wait(hold, [this] { return is_over_ || is_next_made(); });
      }
    }
    changed_.notify_all();
  }

  template <class Take, class Make>
  void help(const Take& take, const Make& make, std::size_t thread) {
    Lock hold(mutex_);
    for (;;) {
      changed_.wait(hold, [this] { return is_over_ || has_room(); });
      Taken* taken = is_over_ ? nullptr : next(take, thread);
      if (!taken) return;
      make_one(*taken, make, thread, hold);
      changed_.notify_all();
    }
  }

  bool is_next_made() const { return !waiting_.empty() && waiting_.front()->is_made; }
  bool has_room() const { return waiting_.size() < most_waiting_; }

  /// The next share; null if there is none, or no room for it.
  template <class Take>
  Taken* next(const Take& take, std::size_t thread) {
    if (is_all_taken_ || !has_room()) return nullptr;
    if (spare_.empty()) spare_.push_back(std::make_unique<Taken>());
    is_all_taken_ = !take(spare_.back()->share, thread);
    if (is_all_taken_) return nullptr;
    waiting_.push_back(std::move(spare_.back()));
    spare_.pop_back();
    waiting_.back()->is_made = false;
    return waiting_.back().get();
  }

  template <class Make>
  void make_one(Taken& taken, const Make& make, std::size_t thread, Lock& hold) {
    hold.unlock();
    make(taken.share, thread);
    hold.lock();
    taken.is_made = true;
  }

  template <class Show>
  bool show_next(const Show& show, Lock& hold) {
    std::unique_ptr<Taken> shown = std::move(waiting_.front());
    waiting_.pop_front();
    hold.unlock();
    const bool goes_on = show(shown->share);
    hold.lock();
    spare_.push_back(std::move(shown));
    return goes_on;
  }

  /// Keeps the exception that is being handled, if it is the first.
  void fail() {
    const Lock hold(mutex_);
    if (!thrown_) thrown_ = std::current_exception();
    is_over_ = true;
    changed_.notify_all();
  }

  std::size_t threads_, most_waiting_;
  Mutex mutex_;
  Condition changed_;
  std::deque<std::unique_ptr<Taken>> waiting_;  ///< taken and not shown, in order
  std::vector<std::unique_ptr<Taken>> spare_;   ///< to be used again
  bool is_all_taken_ = false, is_over_ = false;
  std::exception_ptr thrown_;
};

}  // namespace pliant
