// SPDX-License-Identifier: MIT
// Addresses of sockets, which have the same names on every system, in headers of other names.
#pragma once

#if defined(_WIN32)
#include <winsock2.h>
// After winsock2.h.
#include <ws2tcpip.h>
#else
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#endif

#include <array>
#include <cstring>
#include <memory>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"

namespace pliant::socket_addresses {

/// Throws FileError.
[[noreturn]] inline void fail_to_listen(const std::string& host, int port,
                                        const std::string& reason) {
  throw FileError(printable_name(host) + ":" + std::to_string(port) + ": cannot listen: " + reason);
}

using Addresses = std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)>;

/// Where to listen; `reason_of` says in words what getaddrinfo() fails with. Throws FileError.
template <class ReasonOf>
Addresses addresses_of(const std::string& host, int port, ReasonOf reason_of) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  const int code = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (code != 0) fail_to_listen(host, port, reason_of(code));
  return {found, &::freeaddrinfo};
}

inline bool is_loopback(const sockaddr* address) {
  if (address->sa_family == AF_INET) {
    sockaddr_in four{};
    std::memcpy(&four, address, sizeof four);
    return ntohl(four.sin_addr.s_addr) >> 24 == 127;
  }
  sockaddr_in6 six{};
  if (address->sa_family == AF_INET6) std::memcpy(&six, address, sizeof six);
  return IN6_IS_ADDR_LOOPBACK(&six.sin6_addr);
}

/// The address of a socket's own end. Of IPv6 only the port, which lies at the same place.
template <class Number>
sockaddr_in own_address(Number socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  sockaddr_in four{};
  std::memcpy(&four, &address, sizeof four);
  return four;
}

/// "127.0.0.1:43210".
inline std::string name_of(const sockaddr_storage& address, socklen_t size) {
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> port{};
  const auto* any = reinterpret_cast<const sockaddr*>(&address);
  const int code = ::getnameinfo(any, size, host.data(), NI_MAXHOST, port.data(), NI_MAXSERV,
                                 NI_NUMERICHOST | NI_NUMERICSERV);
  return code == 0 ? std::string(host.data()) + ":" + port.data() : "unknown";
}

}  // namespace pliant::socket_addresses
