// SPDX-License-Identifier: MIT
// Data shared by a run and the thread that serves its IMD clients: frames one way, requests the
// other. The run never waits for a slow or silent client unless asked to.
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
#include "pliant/base/system/sockets.hpp"
#include "pliant/perturb/steering.hpp"
#include "pliant/stream/imd_follower.hpp"
#include "pliant/stream/imd_packets.hpp"

namespace pliant {

/// Summary of serving all clients.
struct ImdSummary {
  std::int64_t clients = 0;         ///< clients that followed the run
  std::int64_t refused = 0;         ///< clients turned away, or whose connection failed
  std::int64_t frames_sent = 0;     ///< complete frames
  std::int64_t frames_dropped = 0;  ///< frames for which a client was too slow
  std::int64_t forces_taken = 0;    ///< packets of forces
  double seconds_waited = 0.0;      ///< by the run: for a client, or because one paused it
};

class ImdExchange {
 public:
  struct Options {
    bool waits = false;                      ///< the run waits for a client, and for slow ones
    bool can_kill = false;                   ///< clients may end the run
    std::function<bool()> should_stop = {};  ///< ends waiting
  };

  ImdExchange(const Options& options, std::shared_ptr<Steering> steering);

  // Called by the run.
  /// After each step: waits while the run is paused or has to wait. Returns whether some client is
  /// to get a frame of it.
  bool wants(std::int64_t step);
  /// Takes the frame that was wanted: its coordinates, and a function that makes the head for each
  /// client.
  using MakeHead = std::function<Bytes(const ImdCounts&)>;
  void put(std::shared_ptr<Bytes> coordinates, const MakeHead& head_for);
  /// Returns a buffer for coordinates, with arbitrary contents.
  std::shared_ptr<Bytes> buffer();
  bool was_killed() const { return is_killed_.load(std::memory_order_relaxed); }
  /// Says that no more frames come: clients get what is left.
  void finish();
  /// Logs the messages that are waiting.
  void tell(const Log& log);
  ImdSummary summary();

  // Called by the thread.
  const Wake& woken() const { return wake_; }
  bool is_finishing();
  /// Adds a client, which follows until end_client().
  ImdFollower& begin_client();
  /// Removes a client, and releases what it pulled and held. Other clients are not affected.
  void end_client(ImdFollower& client);
  /// Counts a client that was refused or is no longer served, and keeps the reason for tell().
  void refuse(const std::string& message);
  /// Says that everything for the client has been sent: it gets a frame of the next step that it
  /// asks for, the newest possible.
  void set_ready(ImdFollower& client);
  /// Takes the next frame to be sent; returns false if there is none.
  bool next_frame(ImdFollower& client, ImdOutgoing& frame);
  /// Takes back a frame that was sent completely.
  void take_back(ImdOutgoing sent);
  void pause(ImdFollower& client, bool is_paused);
  void set_rate(ImdFollower& client, std::int64_t every);
  void set_waits(bool waits);
  void pull(ImdFollower& client, const std::vector<JointForce>& forces);
  /// Ends the run if clients may; otherwise logs that `name` asked for it.
  void kill(const std::string& name);

 private:
  bool must_wait() const;
  bool has_room(const ImdFollower& client) const;
  bool takes(ImdFollower& client, std::int64_t step);
  void wait(std::unique_lock<std::mutex>& hold);
  void keep_message(const std::string& message);

  const Options options_;
  const std::shared_ptr<Steering> steering_;
  const Wake wake_;
  std::atomic<bool> is_killed_{false}, has_messages_{false};
  std::mutex mutex_;  ///< guards the following members
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
