// SPDX-License-Identifier: MIT
// What a run and the thread that serves its IMD client share: frames one way, wishes the other.
// The run never waits for a client that is slow or silent, unless it is told to.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/perturb/steering.hpp"
#include "pliant/stream/imd_packets.hpp"
#include "pliant/stream/sockets.hpp"

namespace pliant {

/// What came of serving.
struct ImdSummary {
  std::int64_t clients = 0;         ///< that followed the run
  std::int64_t refused = 0;         ///< that lost their connection for what they sent
  std::int64_t frames_sent = 0;     ///< as a whole
  std::int64_t frames_dropped = 0;  ///< that a client was too slow for
  std::int64_t forces_taken = 0;    ///< packets of forces
  double seconds_waited = 0.0;      ///< by the run: for a client, or because one paused it
};

class ImdExchange {
 public:
  struct Options {
    bool waits = false;      ///< for a client, and for a slow one
    std::int64_t every = 1;  ///< a frame in so many steps, unless the client asks for another rate
    std::function<bool()> should_stop = {};  ///< ends waiting
  };

  ImdExchange(const Options& options, std::shared_ptr<Steering> steering);

  // Of the run.
  /// After each step: waits while it is paused or has to wait; true if a frame is wanted now.
  bool wants(std::int64_t step);
  void put(Bytes frame);
  /// An empty buffer that has been a frame before.
  Bytes buffer();
  ImdCounts counts();
  bool was_killed() const { return is_killed_.load(std::memory_order_relaxed); }
  /// No more frames come: the client is to be sent what is left.
  void finish();
  /// Says what there is to be told.
  void tell(const Log& log);
  ImdSummary summary();

  // Of the thread.
  const Descriptor& woken() const { return wake_; }
  bool is_finishing();
  void begin_client();
  void end_client();
  void refuse(const std::string& message);
  /// The next frame to be sent; false if there is none.
  bool next_frame(Bytes& frame);
  /// A frame that has been sent as a whole.
  void take_back(Bytes sent);
  void pause(bool is_paused);
  void toggle_pause();
  void set_rate(std::int64_t every);
  void set_waits(bool waits);
  void pull(const std::vector<JointForce>& forces);
  void kill();

 private:
  bool must_wait() const;
  void wait(std::unique_lock<std::mutex>& hold);

  const Options options_;
  const std::shared_ptr<Steering> steering_;
  const Descriptor wake_;
  std::atomic<bool> is_killed_{false}, has_messages_{false};
  std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  std::deque<Bytes> frames_, spare_;
  bool is_followed_ = false, is_paused_ = false, is_finishing_ = false;
  bool waits_for_client_;
  std::int64_t every_;
  ImdCounts counts_;  ///< of this client
  ImdSummary summary_;
  std::vector<std::string> messages_;
};

}  // namespace pliant
