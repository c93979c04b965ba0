// SPDX-License-Identifier: MIT
// IMD server (live streaming, interactive steering): VMD, MDAnalysis and others follow a run while
// it goes, and pull on its atoms. README.md says what is sent.
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

/// How a run is served. Checked when a server is made.
struct ImdOptions {
  std::string host = "127.0.0.1";  ///< name or number of the interface to listen on
  int port = 8888;                 ///< 0: any free one
  int version = 3;                 ///< 2 for VMD, 3 for MDAnalysis
  bool wait = false;               ///< the run waits for a client, and for slow ones
  bool kill = false;               ///< clients may end the run
  int most_clients = 16;           ///< at once; further ones are turned away
  std::int64_t every = 1;          ///< a frame in so many steps, unless the client asks otherwise
  double timestep = 0.01;          ///< ps, as told to clients
  bool swapped = false;            ///< speak in the byte order that is not this machine's
  std::function<bool()> should_stop = {};  ///< asked while the run waits
  Log log = {};                            ///< called in the run's thread only
  ImdPatience patience = {};
};

/// Serves all clients in one thread of its own. None waits for another. IMD has no passwords:
/// whoever reaches the port may follow, pull and, with options.kill, end the run.
class ImdServer {
 public:
  /// Listens at once. What clients pull on goes to `steering`. Throws OptionError naming the
  /// option, FileError where it cannot listen.
  ImdServer(std::size_t joint_count, const ImdOptions& options, std::shared_ptr<Steering> steering);
  /// As close().
  ~ImdServer();
  ImdServer(const ImdServer&) = delete;
  ImdServer& operator=(const ImdServer&) = delete;

  int port() const { return listener_.port; }
  bool is_loopback() const { return listener_.is_loopback; }

  /// To be asked after each step: whether a client is to see it. Waits while a client has paused
  /// the run, or, with options.wait, until one is there and all of them read.
  bool wants(std::int64_t step);
  /// Sends a frame, of joint_count positions, to those who want it.
  void show(const Frame& frame);
  /// Whether a client has asked the run to end.
  bool was_killed() const { return exchange_.was_killed(); }

  ImdSummary summary() { return exchange_.summary(); }

  /// No more frames come: clients are told so as soon as they have read what is left. Returns at
  /// once.
  void finish() { exchange_.finish(); }
  /// finish(), and waits until each client has read what is left: at most options.patience.finish
  /// from its last sign of life.
  ImdSummary close();

 private:
  using Sessions = std::vector<std::unique_ptr<ImdSession>>;

  void serve();
  void turn(Sessions& sessions);
  bool goes_on(ImdSession& session, short found);
  void admit(Sessions& sessions);

  ImdOptions options_;
  ImdFormat format_;
  std::size_t joint_count_;
  Listener listener_;
  ImdExchange exchange_;
  std::jthread thread_;  ///< last: it uses all of them
};

}  // namespace pliant
