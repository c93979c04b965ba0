// SPDX-License-Identifier: MIT
// IMD server (live streaming, interactive steering): VMD, MDAnalysis and others follow a run while
// it goes, and pull on its atoms. README.md says what is sent.
#pragma once

#include <memory>
#include <string>
#include <thread>

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
  bool wait = false;               ///< the run waits for a client, and for a slow one
  std::int64_t every = 1;          ///< a frame in so many steps, unless the client asks otherwise
  double timestep = 0.01;          ///< ps, as told to clients
  bool swapped = false;            ///< speak in the byte order that is not this machine's
  std::function<bool()> should_stop = {};  ///< asked while the run waits
  Log log = {};                            ///< called in the run's thread only
  ImdPatience patience = {};
};

/// Serves one client after another in a thread of its own. IMD has no passwords: whoever reaches
/// the port may follow, pull and end the run.
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

  /// To be asked after each step: whether the client wants to see it. Waits while the client has
  /// paused the run, or, with options.wait, for a client that reads.
  bool wants(std::int64_t step);
  /// Sends a frame, of joint_count positions.
  void show(const Frame& frame);
  /// Whether a client has asked the run to end.
  bool was_killed() const { return exchange_.was_killed(); }

  ImdSummary summary() { return exchange_.summary(); }

  /// Sends what is left and lets the client read it: at most options.patience.finish from its last
  /// sign of life.
  ImdSummary close();

 private:
  void serve();
  void follow(Peer peer);
  bool wait_for_knock();

  ImdOptions options_;
  ImdFormat format_;
  std::size_t joint_count_;
  Listener listener_;
  ImdExchange exchange_;
  std::jthread thread_;  ///< last: it uses all of them
};

}  // namespace pliant
