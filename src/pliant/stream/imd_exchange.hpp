// SPDX-License-Identifier: MIT
// What a run and the thread that serves its IMD clients share: frames one way, wishes the other.
// The run never waits for a client that is slow or silent, unless it is told to.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/perturb/steering.hpp"
#include "pliant/stream/imd_follower.hpp"
#include "pliant/stream/imd_packets.hpp"
#include "pliant/stream/sockets.hpp"

namespace pliant {

/// What came of serving, all clients together.
struct ImdSummary {
  std::int64_t clients = 0;         ///< that followed the run
  std::int64_t refused = 0;         ///< that were turned away, or lost their connection
  std::int64_t frames_sent = 0;     ///< as a whole
  std::int64_t frames_dropped = 0;  ///< that a client was too slow for
  std::int64_t forces_taken = 0;    ///< packets of forces
  double seconds_waited = 0.0;      ///< by the run: for a client, or because one paused it
};

class ImdExchange {
 public:
  struct Options {
    bool waits = false;      ///< for a client, and for a slow one
    bool can_kill = false;   ///< clients may end the run
    std::int64_t every = 1;  ///< a frame in so many steps, unless a client asks for another rate
    std::function<bool()> should_stop = {};  ///< ends waiting
  };

  ImdExchange(const Options& options, std::shared_ptr<Steering> steering);

  // Of the run.
  /// After each step: waits while it is paused or has to wait; true if some client is to be given a
  /// frame of it.
  bool wants(std::int64_t step);
  /// The frame that was wanted: coordinates, and what is said before them to each client.
  using MakeHead = std::function<Bytes(const ImdCounts&)>;
  void put(std::shared_ptr<Bytes> coordinates, const MakeHead& head_for);
  /// A buffer for coordinates, with whatever is in it.
  std::shared_ptr<Bytes> buffer();
  bool was_killed() const { return is_killed_.load(std::memory_order_relaxed); }
  /// No more frames come: the clients are to be sent what is left.
  void finish();
  /// Says what there is to be told.
  void tell(const Log& log);
  ImdSummary summary();

  // Of the thread.
  const Descriptor& woken() const { return wake_; }
  bool is_finishing();
  /// A client follows from now on, until it ends.
  ImdFollower& begin_client();
  /// What it pulled and held is free; the other clients do not notice.
  void end_client(ImdFollower& client);
  /// Counts a client that was not served, or no longer is, and tells why.
  void refuse(const std::string& message);
  /// All that there was for the client is on its way: it gets a frame of the next step that it asks
  /// for, the newest there can be.
  void set_ready(ImdFollower& client);
  /// The next frame to be sent; false if there is none.
  bool next_frame(ImdFollower& client, ImdOutgoing& frame);
  /// A frame that has been sent as a whole.
  void take_back(ImdOutgoing sent);
  void pause(ImdFollower& client, bool is_paused);
  void set_rate(ImdFollower& client, std::int64_t every);
  void set_waits(bool waits);
  void pull(ImdFollower& client, const std::vector<JointForce>& forces);
  /// Ends the run, where clients may; else it is said that `name` asked for it.
  void kill(const std::string& name);

 private:
  bool must_wait() const;
  bool has_room(const ImdFollower& client) const;
  bool takes(ImdFollower& client, std::int64_t step);
  void wait(std::unique_lock<std::mutex>& hold);
  void keep_message(const std::string& message);

  const Options options_;
  const std::shared_ptr<Steering> steering_;
  const Descriptor wake_;
  std::atomic<bool> is_killed_{false}, has_messages_{false};
  std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  std::list<ImdFollower> followers_;  ///< in the order in which they came
  std::vector<std::shared_ptr<Bytes>> spare_;
  bool is_finishing_ = false;
  bool waits_for_client_;
  ImdSummary summary_;
  std::vector<std::string> messages_;
  std::int64_t messages_kept_ = 0;
};

}  // namespace pliant
