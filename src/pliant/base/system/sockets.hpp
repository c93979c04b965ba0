// SPDX-License-Identifier: MIT
// TCP sockets that never block, closed by their owners' destructors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace pliant {

/// Owns a socket.
class Socket {
 public:
  using Handle = std::intptr_t;  ///< POSIX: a descriptor

  Socket() = default;
  explicit Socket(Handle handle) : handle_(handle) {}
  ~Socket();
  Socket(Socket&& other) noexcept : handle_(std::exchange(other.handle_, none)) {}
  Socket& operator=(Socket&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }

  static constexpr Handle none = -1;
  Handle get() const { return handle_; }
  explicit operator bool() const { return handle_ != none; }

 private:
  Handle handle_ = none;
};

/// A listening socket and its address.
struct Listener {
  Socket socket;
  int port = 0;
  bool is_loopback = true;  ///< can be reached only from this machine
};

/// Listens on a port; 0 takes any free one. Throws FileError ("HOST:PORT: cannot listen: REASON").
Listener listen_on(const std::string& host, int port);

/// A client that connects.
struct Peer {
  Socket socket;     ///< none if the client has gone
  std::string name;  ///< "127.0.0.1:43210"
};

/// A packet to it goes out at once; a machine that is gone is noticed within a minute.
Peer accept_peer(const Listener& listener);

/// What came of an attempt to move bytes.
struct Transfer {
  std::size_t count = 0;
  bool is_open = true;  ///< false: the other side has gone; true with no bytes: not now
};

/// Takes what has come, up to bytes.size().
Transfer receive(const Socket& socket, std::span<std::byte> bytes);

using Part = std::span<const std::byte>;
/// Sends the parts one after the other, as far as they go now.
Transfer send_parts(const Socket& socket, std::span<const Part> parts);

/// Says that nothing more is sent.
void end_sending(const Socket& socket);

/// What to wait for at a socket, and what was found.
struct SocketEvents {
  Socket::Handle socket = Socket::none;  ///< none: passed over
  bool to_read = true, to_write = false;
  bool can_read = false, can_write = false;  ///< a closed or broken connection can be read
};

/// Waits until something is found at one of the sockets, or for so many milliseconds; -1: for ever.
void wait_for(std::span<SocketEvents> sockets, int milliseconds);

/// One thread wakes another that waits for sockets.
class Wake {
 public:
  /// Throws FileError.
  Wake();
  /// May be called by any thread.
  void wake() const;
  /// Forgets all calls of wake().
  void sleep_again() const;
  Socket::Handle to_wait_for() const { return receiver_.get(); }

 private:
  Socket receiver_, sender_;
};

}  // namespace pliant
