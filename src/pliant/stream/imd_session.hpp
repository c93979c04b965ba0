// SPDX-License-Identifier: MIT
// One IMD client, from its handshake until it goes.
#pragma once

#include <chrono>
#include <string>

#include "pliant/stream/imd_commands.hpp"
#include "pliant/stream/imd_exchange.hpp"

namespace pliant {

/// How long a session waits for what has to come.
struct ImdPatience {
  using Milliseconds = std::chrono::milliseconds;
  /// For GO, after the handshake, as the specification has it: then the client gives way to another
  /// that knocks.
  Milliseconds go{1000};
  /// For GO while nobody else knocks: imdclient first makes room for 10 MB of frames, which of a
  /// few atoms takes most of a second, and more on a busy machine.
  Milliseconds go_alone{5000};
  Milliseconds packet{5000};   ///< for the next byte of a packet
  Milliseconds finish{10000};  ///< at the end, for a client that takes nothing more
};

class ImdSession {
 public:
  /// `others` can be read from while another client knocks; null: that is not looked at.
  ImdSession(Peer peer, const ImdFormat& format, std::size_t joint_count, ImdExchange& exchange,
             const ImdPatience& patience = {}, const Descriptor* others = nullptr);
  /// The exchange then knows of no client.
  ~ImdSession();
  ImdSession(const ImdSession&) = delete;
  ImdSession& operator=(const ImdSession&) = delete;

  /// Waits for what comes next, and does it; false: the session is over. Throws InputError for what
  /// no client may do.
  bool step();

  const std::string& name() const { return peer_.name; }

 private:
  using Clock = std::chrono::steady_clock;
  enum class Phase { greeting, following, flushing, draining };

  void begin_finish();
  void fill();
  bool gives_way() const;
  int milliseconds_left() const;
  Clock::time_point deadline() const;
  bool is_late() const { return Clock::now() >= deadline(); }
  bool expire() const;
  bool receive();
  bool send();
  bool obey();
  bool obey(const ImdCommand& command);
  void begin(const ImdCommand& command);

  Peer peer_;
  ImdFormat format_;
  ImdExchange& exchange_;
  ImdPatience patience_;
  const Descriptor* others_;
  ImdCommandReader reader_;
  Phase phase_ = Phase::greeting;
  Clock::time_point since_ = Clock::now();  ///< the last progress of what is waited for
  Bytes greeting_, frame_;
  Bytes* out_ = &greeting_;
  std::size_t sent_ = 0;  ///< bytes of *out_
};

}  // namespace pliant
