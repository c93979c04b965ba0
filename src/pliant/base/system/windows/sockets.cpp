// SPDX-License-Identifier: MIT
#include "pliant/base/system/sockets.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/base/system/socket_addresses_internal.hpp"

namespace pliant {
namespace {

using socket_addresses::Addresses;
using socket_addresses::addresses_of;
using socket_addresses::fail_to_listen;
using socket_addresses::is_loopback;
using socket_addresses::name_of;
using socket_addresses::own_address;

/// Must be called before any other function of sockets; done once, and undone by the system.
void start_sockets() {
  static const bool started = [] {
    WSADATA facts{};
    return ::WSAStartup(MAKEWORD(2, 2), &facts) == 0;
  }();
  if (!started) throw FileError("no sockets: this Windows has no Winsock 2.2");
}

std::string reason_of(int error) {
  std::array<char, 256> text{};
  const DWORD size = ::FormatMessageA(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS,
                                      nullptr, static_cast<DWORD>(error), 0, text.data(),
                                      static_cast<DWORD>(text.size()), nullptr);
  std::string reason(text.data(), size);
  while (!reason.empty() &&
         (reason.back() == '\n' || reason.back() == '\r' || reason.back() == '.'))
    reason.pop_back();
  return reason.empty() ? "error " + std::to_string(error) : reason;
}

SOCKET number_of(const Socket& socket) { return static_cast<SOCKET>(socket.get()); }

Socket owned(SOCKET number) { return Socket(static_cast<Socket::Handle>(number)); }

void never_block(const Socket& socket) {
  u_long yes = 1;
  ::ioctlsocket(number_of(socket), FIONBIO, &yes);
}

void set(const Socket& socket, int level, int option, int value) {
  ::setsockopt(number_of(socket), level, option, reinterpret_cast<const char*>(&value),
               sizeof value);
}

/// Few bytes wait in the system: who reads slowly would get frames that are megabytes old.
void set_options(const Socket& socket) {
  constexpr int most_unsent = 16384, seconds = 15;
  set(socket, SOL_SOCKET, SO_SNDBUF, most_unsent);
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set(socket, IPPROTO_TCP, TCP_KEEPIDLE, seconds);
  set(socket, IPPROTO_TCP, TCP_KEEPINTVL, seconds);
  set(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);
}

bool passes(int error) { return error == WSAEWOULDBLOCK || error == WSAEINTR; }

Socket listening_socket(const addrinfo& address, const std::string& host, int port) {
  Socket socket = owned(::socket(address.ai_family, SOCK_STREAM, 0));
  if (!socket) fail_to_listen(host, port, reason_of(::WSAGetLastError()));
  // What SO_REUSEADDR means elsewhere is the rule here, where that option lets others steal a port.
  set(socket, SOL_SOCKET, SO_EXCLUSIVEADDRUSE, 1);
  const auto size = static_cast<int>(address.ai_addrlen);
  if (::bind(number_of(socket), address.ai_addr, size) != 0 || ::listen(number_of(socket), 16) != 0)
    fail_to_listen(host, port, reason_of(::WSAGetLastError()));
  return socket;
}

WSAPOLLFD asked_of(const SocketEvents& events) {
  const int wanted = (events.to_read ? POLLRDNORM : 0) | (events.to_write ? POLLWRNORM : 0);
  return {static_cast<SOCKET>(events.socket), static_cast<SHORT>(wanted), 0};
}

}  // namespace

Socket::~Socket() {
  if (handle_ != none) ::closesocket(static_cast<SOCKET>(handle_));
}

Listener listen_on(const std::string& host, int port) {
  start_sockets();
  const Addresses address = addresses_of(host, port, reason_of);
  Socket socket = listening_socket(*address, host, port);
  never_block(socket);
  const int found = ntohs(own_address(number_of(socket)).sin_port);
  return {std::move(socket), found, is_loopback(address->ai_addr)};
}

Peer accept_peer(const Listener& listener) {
  sockaddr_storage address{};
  int size = sizeof address;
  Socket socket =
      owned(::accept(number_of(listener.socket), reinterpret_cast<sockaddr*>(&address), &size));
  if (!socket) return {};
  never_block(socket);
  set_options(socket);
  return {std::move(socket), name_of(address, size)};
}

Transfer receive(const Socket& socket, std::span<std::byte> bytes) {
  const auto room =
      static_cast<int>(std::min<std::size_t>(bytes.size(), std::numeric_limits<int>::max()));
  const int count = ::recv(number_of(socket), reinterpret_cast<char*>(bytes.data()), room, 0);
  if (count < 0) return {0, passes(::WSAGetLastError())};
  return {static_cast<std::size_t>(count), count > 0};
}

Transfer send_parts(const Socket& socket, std::span<const Part> parts) {
  std::vector<WSABUF> all;
  for (const Part& part : parts)
    all.push_back({static_cast<ULONG>(part.size()),
                   reinterpret_cast<char*>(const_cast<std::byte*>(part.data()))});
  DWORD count = 0;
  if (::WSASend(number_of(socket), all.data(), static_cast<DWORD>(all.size()), &count, 0, nullptr,
                nullptr) != 0)
    return {0, passes(::WSAGetLastError())};
  return {count, true};
}

void end_sending(const Socket& socket) { ::shutdown(number_of(socket), SD_SEND); }

/// WSAPoll() refuses sockets that are none, and must not wait for none at all.
void wait_for(std::span<SocketEvents> sockets, int milliseconds) {
  std::vector<WSAPOLLFD> waits;
  std::vector<SocketEvents*> asked;
  for (SocketEvents& events : sockets) {
    events.can_read = events.can_write = false;
    if (events.socket == Socket::none) continue;
    waits.push_back(asked_of(events));
    asked.push_back(&events);
  }
  ::WSAPoll(waits.data(), static_cast<ULONG>(waits.size()), milliseconds);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    asked[k]->can_read = (waits[k].revents & ~POLLWRNORM) != 0;
    asked[k]->can_write = (waits[k].revents & POLLWRNORM) != 0;
  }
}

/// Two sockets of this machine that know each other: there are no pipes that can be waited for.
Wake::Wake() {
  start_sockets();
  const Listener listener = listen_on("127.0.0.1", 0);
  sender_ = owned(::socket(AF_INET, SOCK_STREAM, 0));
  const sockaddr_in address = own_address(number_of(listener.socket));
  const auto* any = reinterpret_cast<const sockaddr*>(&address);
  if (!sender_ || ::connect(number_of(sender_), any, sizeof address) != 0)
    throw FileError("no pair of sockets: " + reason_of(::WSAGetLastError()));
  // Whoever else may have connected meanwhile is not ours.
  const std::string own = [&] {
    sockaddr_storage storage{};
    const sockaddr_in four = own_address(number_of(sender_));
    std::memcpy(&storage, &four, sizeof four);
    return name_of(storage, sizeof four);
  }();
  while (receiver_.get() == Socket::none) {
    Peer peer = accept_peer(listener);
    if (peer.name == own) receiver_ = std::move(peer.socket);
  }
  never_block(sender_);
}

void Wake::wake() const {
  const char one = 1;
  // Sending fails only where the other has not seen many calls yet.
  static_cast<void>(::send(number_of(sender_), &one, 1, 0));
}

void Wake::sleep_again() const {
  std::array<char, 256> calls{};
  while (::recv(number_of(receiver_), calls.data(), static_cast<int>(calls.size()), 0) > 0) {
  }
}

}  // namespace pliant
