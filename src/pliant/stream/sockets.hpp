// SPDX-License-Identifier: MIT
// TCP sockets, closed when they go.
#pragma once

#include <string>
#include <utility>

namespace pliant {

/// A file descriptor of its own.
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

/// A socket that listens, and where.
struct Listener {
  Descriptor socket;
  int port = 0;
  bool is_loopback = true;  ///< only programs of this machine reach it
};

/// Port 0: any free one. Throws FileError naming host and port.
Listener listen_on(const std::string& host, int port);

/// Someone who connects.
struct Peer {
  Descriptor socket;  ///< does not block; none: whoever knocked has gone
  std::string name;   ///< "127.0.0.1:43210"
};

Peer accept_peer(const Listener& listener);

/// What one thread writes to wake another that polls.
Descriptor make_wake();
void wake(const Descriptor& descriptor);
void sleep_again(const Descriptor& descriptor);

}  // namespace pliant
