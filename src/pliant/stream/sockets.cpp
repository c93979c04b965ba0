// SPDX-License-Identifier: MIT
#include "pliant/stream/sockets.hpp"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"

namespace pliant {
namespace {

using Addresses = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

[[noreturn]] void fail_to_listen(const std::string& host, int port, const char* reason) {
  throw FileError("IMD on " + printable_name(host) + ":" + std::to_string(port) +
                  ": cannot listen: " + reason);
}

Addresses addresses_of(const std::string& host, int port) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int code = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (code != 0) fail_to_listen(host, port, gai_strerror(code));
  return {found, freeaddrinfo};
}

bool is_loopback(const sockaddr* address) {
  if (address->sa_family == AF_INET) {
    sockaddr_in four{};
    std::memcpy(&four, address, sizeof four);
    return ntohl(four.sin_addr.s_addr) >> 24 == 127;
  }
  sockaddr_in6 six{};
  if (address->sa_family == AF_INET6) std::memcpy(&six, address, sizeof six);
  return IN6_IS_ADDR_LOOPBACK(&six.sin6_addr);
}

int port_of(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  sockaddr_in four{};  // the port of IPv6 lies at the same place
  std::memcpy(&four, &address, sizeof four);
  return ntohs(four.sin_port);
}

std::string name_of(const sockaddr_storage& address, socklen_t size) {
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> port{};
  const auto* any = reinterpret_cast<const sockaddr*>(&address);
  const int code = getnameinfo(any, size, host.data(), host.size(), port.data(), port.size(),
                               NI_NUMERICHOST | NI_NUMERICSERV);
  return code == 0 ? std::string(host.data()) + ":" + port.data() : "unknown";
}

void set(int socket, int level, int option, int value) {
  setsockopt(socket, level, option, &value, sizeof value);
}

/// Bytes that the system may keep for a client before they are on their way. As many as it likes,
/// and who reads slowly would get frames that are megabytes old.
constexpr int most_unsent = 16384;

/// A packet goes out at once; a machine that is gone is noticed within a minute.
void set_options(int socket) {
  set(socket, IPPROTO_TCP, TCP_NOTSENT_LOWAT, most_unsent);
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set(socket, IPPROTO_TCP, TCP_KEEPIDLE, 15);
  set(socket, IPPROTO_TCP, TCP_KEEPINTVL, 15);
  set(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

Listener listen_on(const std::string& host, int port) {
  const Addresses address = addresses_of(host, port);
  const int family = address->ai_family;
  Descriptor socket(::socket(family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket) fail_to_listen(host, port, std::strerror(errno));
  set(socket.get(), SOL_SOCKET, SO_REUSEADDR, 1);
  if (bind(socket.get(), address->ai_addr, address->ai_addrlen) != 0 ||
      listen(socket.get(), 16) != 0)
    fail_to_listen(host, port, std::strerror(errno));
  const int found = port_of(socket.get());
  return {std::move(socket), found, is_loopback(address->ai_addr)};
}

Peer accept_peer(const Listener& listener) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  Descriptor socket(accept4(listener.socket.get(), reinterpret_cast<sockaddr*>(&address), &size,
                            SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (!socket) return {};
  set_options(socket.get());
  return {std::move(socket), name_of(address, size)};
}

Descriptor make_wake() {
  Descriptor descriptor(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!descriptor) throw FileError(std::string("IMD: no event: ") + std::strerror(errno));
  return descriptor;
}

void wake(const Descriptor& descriptor) {
  const std::uint64_t one = 1;
  // Writing fails only where the descriptor has been woken 2^64 times and not slept since.
  if (write(descriptor.get(), &one, sizeof one) < 0) return;
}

void sleep_again(const Descriptor& descriptor) {
  std::uint64_t count = 0;
  if (read(descriptor.get(), &count, sizeof count) < 0) return;  // nobody woke it
}

}  // namespace pliant
