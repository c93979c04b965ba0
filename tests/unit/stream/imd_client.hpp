// SPDX-License-Identifier: MIT
// The other end of IMD, for tests: bytes as a client writes and reads them, one by one.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/base/system/sockets.hpp"
#include "pliant/stream/imd_packets.hpp"

namespace pliant::test {

/// Two sockets that talk to each other; the first does not block.
std::pair<Socket, Socket> socket_pair();

/// Connects to a port of this machine.
Socket connect_to(int port);

/// A number as eight hexadecimal digits name its bytes: "0000000a".
Bytes bytes_of(std::string_view hexadecimal);
Bytes operator+(Bytes a, const Bytes& b);

/// A header.
Bytes packet(ImdType type, std::int32_t value = 0);

/// A packet of forces in this machine's byte order.
Bytes forces(std::int32_t count, const std::vector<std::int32_t>& atoms,
             const std::vector<float>& numbers);

void send_all(const Socket& socket, const Bytes& bytes);
/// So many bytes, or fewer at the end of the stream.
Bytes receive(const Socket& socket, std::size_t count);
/// What comes until the other side ends.
Bytes receive_all(const Socket& socket);

}  // namespace pliant::test
