// SPDX-License-Identifier: MIT
// One IMD client, from its handshake until it goes.
#pragma once

#include <chrono>
#include <string>

#include "pliant/stream/imd_commands.hpp"
#include "pliant/stream/imd_exchange.hpp"

namespace pliant {

/// How long the server waits for a client.
struct ImdPatience {
  using Milliseconds = std::chrono::milliseconds;
  /// For GO after the handshake. The specification asks for 1 s, but imdclient first allocates 10
  /// MB of frames, which with few atoms takes most of that, and tens of seconds on a busy machine.
  Milliseconds go{60'000};
  Milliseconds packet{5000};     ///< for the next byte of a packet
  Milliseconds reading{60'000};  ///< for it to take a byte of what is waiting
  Milliseconds finish{10'000};   ///< at the end, for a client that takes nothing more
};

/// Never blocks: the thread that serves it polls for all sessions.
class ImdSession {
 public:
  using Clock = std::chrono::steady_clock;

  ImdSession(Peer peer, const ImdFormat& format, std::size_t joint_count, ImdExchange& exchange,
             const ImdPatience& patience = {});
  /// Removes this client from the exchange.
  ~ImdSession();
  ImdSession(const ImdSession&) = delete;
  ImdSession& operator=(const ImdSession&) = delete;

  const std::string& name() const { return peer_.name; }

  /// What to wait for at its socket. Takes the next frame when the last one has been sent.
  SocketEvents events();
  /// Latest time for the next step().
  Clock::time_point deadline() const;
  /// Handles the events `found` by poll(). Returns false if the session is over. Throws InputError
  /// for an invalid command.
  bool step(const SocketEvents& found);

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
  ImdFollower* follower_ = nullptr;  ///< null until it follows
  Phase phase_ = Phase::greeting;
  Clock::time_point since_ = Clock::now();  ///< last progress of the current phase
  Clock::time_point took_ = since_;         ///< when the client took a byte, or was given one
  bool is_paused_ = false;
  bool is_ready_ = false;  ///< whether the exchange has it as ready
  ImdOutgoing out_;
  std::size_t sent_ = 0;  ///< bytes of out_
};

}  // namespace pliant
