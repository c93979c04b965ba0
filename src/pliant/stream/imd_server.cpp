// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_server.hpp"

#include <poll.h>

#include <array>

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
  if (options.every < 1) refuse("every", options.every, "from 1");
  return options;
}

}  // namespace

ImdServer::ImdServer(std::size_t joint_count, const ImdOptions& options,
                     std::shared_ptr<Steering> steering)
    : options_(checked(options)),
      format_{options.version, options.swapped},
      joint_count_(joint_count),
      listener_(listen_on(options.host, options.port)),
      exchange_({options.wait, options.every, options.should_stop}, std::move(steering)),
      thread_([this] { serve(); }) {}

ImdServer::~ImdServer() { close(); }

bool ImdServer::wants(std::int64_t step) {
  exchange_.tell(options_.log);
  return exchange_.wants(step);
}

void ImdServer::show(const Frame& frame) {
  Bytes bytes = exchange_.buffer();
  imd_frame(format_, frame, options_.timestep, exchange_.counts(), bytes);
  exchange_.put(std::move(bytes));
}

ImdSummary ImdServer::close() {
  exchange_.finish();
  if (thread_.joinable()) thread_.join();
  exchange_.tell(options_.log);
  return exchange_.summary();
}

void ImdServer::serve() {
  while (!exchange_.is_finishing())
    if (wait_for_knock()) follow(accept_peer(listener_));
}

bool ImdServer::wait_for_knock() {
  std::array<pollfd, 2> waits{
      {{exchange_.woken().get(), POLLIN, 0}, {listener_.socket.get(), POLLIN, 0}}};
  poll(waits.data(), waits.size(), -1);
  if (waits[0].revents != 0) sleep_again(exchange_.woken());
  return waits[1].revents != 0;
}

void ImdServer::follow(Peer peer) {
  if (!peer.socket) return;
  ImdSession session(std::move(peer), format_, joint_count_, exchange_, options_.patience,
                     &listener_.socket);
  try {
    while (session.step()) continue;
  } catch (const Error& error) {
    exchange_.refuse("IMD client " + session.name() + " dropped: " + error.what());
  }
}

}  // namespace pliant
