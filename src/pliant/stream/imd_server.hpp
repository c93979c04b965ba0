// SPDX-License-Identifier: MIT
// IMD server (live streaming, interactive steering): VMD, MDAnalysis and other programs follow a
// run and pull on its atoms. README.md describes what is sent.
#pragma once

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/perturb/steering.hpp"
#include "pliant/stream/imd_exchange.hpp"
#include "pliant/stream/imd_session.hpp"

namespace pliant {

/// Options of a server. Checked when it is made.
struct ImdOptions {
  std::string host = "127.0.0.1";          ///< name or number of the interface to listen on
  int port = 8888;                         ///< 0: any free one
  int version = 3;                         ///< 2 for VMD, 3 for MDAnalysis
  bool wait = false;                       ///< the run waits for a client, and for slow ones
  int most_clients = 16;                   ///< at once; others are turned away
  double timestep = 0.01;                  ///< ps, reported to clients
  bool swapped = false;                    ///< use the opposite byte order of this machine's
  std::function<bool()> should_stop = {};  ///< asked while the run waits
  Log log = {};                            ///< called only in the run's thread
  ImdPatience patience = {};
};

/// Serves all clients in a thread of its own; none waits for another. IMD has no passwords: whoever
/// can reach the port may follow and pull and, where only this machine can, end the run.
class ImdServer {
 public:
  /// Starts listening. The pulls of clients go to `steering`. Throws OptionError naming the option,
  /// FileError if it cannot listen.
  ImdServer(std::size_t joint_count, const ImdOptions& options, std::shared_ptr<Steering> steering);
  /// As close().
  ~ImdServer();
  ImdServer(const ImdServer&) = delete;
  ImdServer& operator=(const ImdServer&) = delete;

  int port() const { return listener_.port; }
  bool is_loopback() const { return listener_.is_loopback; }

  /// Called after each step: returns whether a client is to see it. Waits while a client has paused
  /// the run, or, with options.wait, until there is a client and all have read their frames.
  bool wants(std::int64_t step);
  /// Sends a frame, of joint_count positions, to the clients that want it.
  void show(const Frame& frame);
  /// Whether a client has asked the run to end.
  bool was_killed() const { return exchange_.was_killed(); }

  ImdSummary summary() { return exchange_.summary(); }

  /// Says that no more frames come. Clients learn it when they have read what is left. Does not
  /// wait.
  void finish() { exchange_.finish(); }
  /// Calls finish(), and waits until each client has read what is left, or has been silent for
  /// options.patience.finish.
  ImdSummary close();

 private:
  using Sessions = std::vector<std::unique_ptr<ImdSession>>;

  void serve();
  void turn(Sessions& sessions);
  bool goes_on(ImdSession& session, const SocketEvents& found);
  void admit(Sessions& sessions);

  ImdOptions options_;
  ImdFormat format_;
  std::size_t joint_count_;
  Listener listener_;
  ImdExchange exchange_;
  std::jthread thread_;  ///< last, because it uses the other members
};

}  // namespace pliant
