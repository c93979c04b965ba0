// SPDX-License-Identifier: MIT
#include "pliant/base/system/sockets.hpp"

#include <fcntl.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/uio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
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

#if defined(TCP_KEEPIDLE)
constexpr int seconds_until_asked = TCP_KEEPIDLE;
#else
constexpr int seconds_until_asked = TCP_KEEPALIVE;  // macOS
#endif

/// Bytes that the system may keep for a client before they are on their way. As many as it likes,
/// and who reads slowly would get frames that are megabytes old.
constexpr int most_unsent = 16384;

void set(int socket, int level, int option, int value) {
  ::setsockopt(socket, level, option, &value, sizeof value);
}

/// Never blocks, and is closed in programs that this process becomes.
void set_flags(int descriptor) {
  ::fcntl(descriptor, F_SETFD, FD_CLOEXEC);
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) | O_NONBLOCK);
}

void set_options(int socket) {
  set(socket, IPPROTO_TCP, TCP_NOTSENT_LOWAT, most_unsent);
  set(socket, IPPROTO_TCP, TCP_NODELAY, 1);
#if defined(SO_NOSIGPIPE)
  set(socket, SOL_SOCKET, SO_NOSIGPIPE, 1);
#endif
  set(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set(socket, IPPROTO_TCP, seconds_until_asked, 15);
  set(socket, IPPROTO_TCP, TCP_KEEPINTVL, 15);
  set(socket, IPPROTO_TCP, TCP_KEEPCNT, 3);
}

int number_of(const Socket& socket) { return static_cast<int>(socket.get()); }

/// What a call has moved; nothing moved is "not now" for the reasons that pass.
Transfer transfer_of(ssize_t count) {
  if (count < 0) return {0, errno == EAGAIN || errno == EINTR};
  return {static_cast<std::size_t>(count), true};
}

pollfd asked_of(const SocketEvents& events) {
  const int wanted = (events.to_read ? POLLIN : 0) | (events.to_write ? POLLOUT : 0);
  return {static_cast<int>(events.socket), static_cast<short>(wanted), 0};
}

}  // namespace

Socket::~Socket() {
  if (handle_ != none) ::close(static_cast<int>(handle_));
}

Listener listen_on(const std::string& host, int port) {
  const Addresses address = addresses_of(host, port, ::gai_strerror);
  const Socket::Handle handle = ::socket(address->ai_family, SOCK_STREAM, 0);
  Socket socket(handle);
  if (!socket) fail_to_listen(host, port, std::strerror(errno));
  const int number = number_of(socket);
  set_flags(number);
  set(number, SOL_SOCKET, SO_REUSEADDR, 1);
  if (::bind(number, address->ai_addr, address->ai_addrlen) != 0 || ::listen(number, 16) != 0)
    fail_to_listen(host, port, std::strerror(errno));
  const int found = ntohs(own_address(number).sin_port);
  return {std::move(socket), found, is_loopback(address->ai_addr)};
}

Peer accept_peer(const Listener& listener) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  Socket socket(::accept(number_of(listener.socket), reinterpret_cast<sockaddr*>(&address), &size));
  if (!socket) return {};
  set_flags(number_of(socket));
  set_options(number_of(socket));
  return {std::move(socket), name_of(address, size)};
}

Transfer receive(const Socket& socket, std::span<std::byte> bytes) {
  const ssize_t count = ::recv(number_of(socket), bytes.data(), bytes.size(), 0);
  return count == 0 ? Transfer{0, false} : transfer_of(count);
}

Transfer send_parts(const Socket& socket, std::span<const Part> parts) {
  std::vector<iovec> all;
  for (const Part& part : parts) all.push_back({const_cast<std::byte*>(part.data()), part.size()});
  msghdr message{};
  message.msg_iov = all.data();
  message.msg_iovlen = static_cast<decltype(message.msg_iovlen)>(all.size());
  return transfer_of(::sendmsg(number_of(socket), &message, MSG_NOSIGNAL));
}

void end_sending(const Socket& socket) { ::shutdown(number_of(socket), SHUT_WR); }

void wait_for(std::span<SocketEvents> sockets, int milliseconds) {
  std::vector<pollfd> waits;
  for (const SocketEvents& events : sockets) waits.push_back(asked_of(events));
  ::poll(waits.data(), static_cast<nfds_t>(waits.size()), milliseconds);
  for (std::size_t k = 0; k < sockets.size(); ++k) {
    sockets[k].can_read = (waits[k].revents & ~POLLOUT) != 0;
    sockets[k].can_write = (waits[k].revents & POLLOUT) != 0;
  }
}

Wake::Wake() {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) throw FileError(std::string("no pipe: ") + std::strerror(errno));
  receiver_ = Socket(ends[0]);
  sender_ = Socket(ends[1]);
  for (const int end : ends) set_flags(end);
}

void Wake::wake() const {
  const char one = 1;
  // Writing fails only where the pipe is full of calls that the other has not seen yet.
  if (::write(number_of(sender_), &one, 1) < 0) return;
}

void Wake::sleep_again() const {
  std::array<char, 256> calls{};
  while (::read(number_of(receiver_), calls.data(), calls.size()) > 0) {
  }
}

}  // namespace pliant
