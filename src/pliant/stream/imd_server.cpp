// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_server.hpp"

#include <algorithm>
#include <limits>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

const ImdOptions& checked(const ImdOptions& options) {
  const auto refuse = [](const char* name, std::int64_t value, const char* range) {
    throw OptionError(std::string("imd ") + name + " = " + std::to_string(value) + ": must be " +
                      range);
  };
  if (options.port < 0 || options.port > 65535) refuse("port", options.port, "from 0 to 65535");
  if (options.version != 2 && options.version != 3) refuse("version", options.version, "2 or 3");
  if (options.most_clients < 1) refuse("most_clients", options.most_clients, "from 1");
  return options;
}

/// Milliseconds as wait_for() takes them: -1 is for ever.
int milliseconds_until(ImdSession::Clock::time_point deadline) {
  if (deadline == ImdSession::Clock::time_point::max()) return -1;
  const auto left = deadline - ImdSession::Clock::now();
  const auto whole = std::chrono::ceil<std::chrono::milliseconds>(left).count();
  return static_cast<int>(std::clamp<std::int64_t>(whole, 0, std::numeric_limits<int>::max()));
}

Listener listen_for_clients(const ImdOptions& options) {
  try {
    return listen_on(options.host, options.port);
  } catch (const FileError& error) {
    throw FileError(std::string("IMD on ") + error.what());
  }
}

}  // namespace

ImdServer::ImdServer(std::size_t joint_count, const ImdOptions& options,
                     std::shared_ptr<Steering> steering)
    : options_(checked(options)),
      format_{options.version, options.swapped},
      joint_count_(joint_count),
      listener_(listen_for_clients(options)),
      exchange_({options.wait, listener_.is_loopback, options.should_stop}, std::move(steering)),
      thread_([this] { serve(); }) {}

ImdServer::~ImdServer() { close(); }

bool ImdServer::wants(std::int64_t step) {
  exchange_.tell(options_.log);
  return exchange_.wants(step);
}

void ImdServer::show(const Frame& frame) {
  std::shared_ptr<Bytes> coordinates = exchange_.buffer();
  imd_coordinates(format_, frame.positions, *coordinates);
  exchange_.put(std::move(coordinates), [&](const ImdCounts& counts) {
    return imd_head(format_, frame, options_.timestep, counts);
  });
}

ImdSummary ImdServer::close() {
  exchange_.finish();
  if (thread_.joinable()) thread_.join();
  exchange_.tell(options_.log);
  return exchange_.summary();
}

void ImdServer::serve() {
  Sessions sessions;
  while (!exchange_.is_finishing() || !sessions.empty()) turn(sessions);
}

/// Waits until there is something to do for a session, or for a new one, and does it.
void ImdServer::turn(Sessions& sessions) {
  const Socket::Handle knock = exchange_.is_finishing() ? Socket::none : listener_.socket.get();
  std::vector<SocketEvents> waits{{exchange_.woken().to_wait_for()}, {knock}};
  auto deadline = ImdSession::Clock::time_point::max();
  for (const auto& session : sessions) {
    waits.push_back(session->events());
    deadline = std::min(deadline, session->deadline());
  }
  wait_for(waits, milliseconds_until(deadline));
  if (waits[0].can_read) exchange_.woken().sleep_again();
  for (std::size_t k = 0; k < sessions.size(); ++k)
    if (!goes_on(*sessions[k], waits[k + 2])) sessions[k].reset();
  std::erase(sessions, nullptr);
  if (waits[1].can_read) admit(sessions);
}

bool ImdServer::goes_on(ImdSession& session, const SocketEvents& found) {
  try {
    return session.step(found);
  } catch (const Error& error) {
    exchange_.refuse("IMD client " + session.name() + " dropped: " + error.what());
    return false;
  }
}

void ImdServer::admit(Sessions& sessions) {
  Peer peer = accept_peer(listener_);
  if (!peer.socket) return;
  if (sessions.size() < static_cast<std::size_t>(options_.most_clients)) {
    sessions.push_back(std::make_unique<ImdSession>(std::move(peer), format_, joint_count_,
                                                    exchange_, options_.patience));
    return;
  }
  exchange_.refuse("IMD client " + peer.name + " turned away: " + std::to_string(sessions.size()) +
                   " are connected, and no more are served");
}

}  // namespace pliant
