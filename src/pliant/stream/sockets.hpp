// SPDX-License-Identifier: MIT
// TCP sockets, closed by their owners' destructors.
#pragma once

#include <string>
#include <utility>

namespace pliant {

/// Owns a file descriptor.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int get() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }

 private:
  int number_ = -1;
};

/// A listening socket and its address.
struct Listener {
  Descriptor socket;
  int port = 0;
  bool is_loopback = true;  ///< can be reached only from this machine
};

/// Listens on a port; 0 takes any free one. Throws FileError naming host and port.
Listener listen_on(const std::string& host, int port);

/// A client that connects.
struct Peer {
  Descriptor socket;  ///< does not block; none if the client has gone
  std::string name;   ///< "127.0.0.1:43210"
};

Peer accept_peer(const Listener& listener);

/// A descriptor that one thread writes to and thereby wakes another that polls.
Descriptor make_wake();
void wake(const Descriptor& descriptor);
void sleep_again(const Descriptor& descriptor);

}  // namespace pliant
