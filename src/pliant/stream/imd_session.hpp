// SPDX-License-Identifier: MIT
// One IMD client, from its handshake until it goes.
#pragma once

#include <chrono>
#include <string>

#include "pliant/stream/imd_commands.hpp"
#include "pliant/stream/imd_exchange.hpp"

namespace pliant {

/// How long a client is waited for.
struct ImdPatience {
  using Milliseconds = std::chrono::milliseconds;
  /// For GO, after the handshake. The specification asks for 1 s; imdclient first makes room for 10
  /// MB of frames, which of a few atoms takes most of that, and more on a busy machine.
  Milliseconds go{5000};
  Milliseconds packet{5000};    ///< for the next byte of a packet
  Milliseconds reading{10000};  ///< that it takes a byte of what there is for it
  Milliseconds finish{10000};   ///< at the end, for a client that takes nothing more
};

/// Never waits itself: whoever serves many polls for all of them.
class ImdSession {
 public:
  using Clock = std::chrono::steady_clock;

  ImdSession(Peer peer, const ImdFormat& format, std::size_t joint_count, ImdExchange& exchange,
             const ImdPatience& patience = {});
  /// The exchange then knows nothing of this client.
  ~ImdSession();
  ImdSession(const ImdSession&) = delete;
  ImdSession& operator=(const ImdSession&) = delete;

  const std::string& name() const { return peer_.name; }
  int socket() const { return peer_.socket.get(); }

  /// What poll() is to look for. Takes up the next frame where the last one has gone.
  short events();
  /// When step() is to be called at the latest.
  Clock::time_point deadline() const;
  /// Does what there is to be done, `found` being what poll() has found; false: the session is
  /// over. Throws InputError for what no client may do.
  bool step(short found);

 private:
  enum class Phase { greeting, following, flushing, draining };

  void begin_finish();
  void fill();
  bool has_more() const { return sent_ < out_.size(); }
  Clock::time_point packet_deadline() const;
  Clock::time_point reading_deadline() const;
  bool is_late() const { return Clock::now() >= deadline(); }
  bool expire() const;
  bool receive();
  bool send();
  void end_frame();
  bool obey();
  bool obey(const ImdCommand& command);
  void begin(const ImdCommand& command);
  void pause(bool is_paused);

  Peer peer_;
  ImdFormat format_;
  ImdExchange& exchange_;
  ImdPatience patience_;
  ImdCommandReader reader_;
  ImdFollower* follower_ = nullptr;  ///< once it follows
  Phase phase_ = Phase::greeting;
  Clock::time_point since_ = Clock::now();  ///< the last progress of what is waited for
  Clock::time_point took_ = since_;  ///< when the client took a byte, or was given one to take
  bool is_paused_ = false;
  bool is_ready_ = false;  ///< as the exchange has been told
  ImdOutgoing out_;
  std::size_t sent_ = 0;  ///< bytes of out_
};

}  // namespace pliant
