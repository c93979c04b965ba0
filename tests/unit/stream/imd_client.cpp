// SPDX-License-Identifier: MIT
#include "imd_client.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <charconv>
#include <cstring>

namespace pliant::test {

std::pair<Socket, Socket> socket_pair() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return {};
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return {Socket(ends[0]), Socket(ends[1])};
}

Socket connect_to(int port) {
  Socket socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const auto* any = reinterpret_cast<const sockaddr*>(&address);
  return connect(static_cast<int>(socket.get()), any, sizeof address) == 0 ? std::move(socket)
                                                                           : Socket();
}

Bytes bytes_of(std::string_view hexadecimal) {
  Bytes bytes;
  for (std::size_t k = 0; k + 1 < hexadecimal.size(); k += 2) {
    unsigned number = 0;
    std::from_chars(&hexadecimal[k], &hexadecimal[k] + 2, number, 16);
    bytes.push_back(static_cast<std::byte>(number));
  }
  return bytes;
}

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Bytes packet(ImdType type, std::int32_t argument) {
  const std::array<std::uint32_t, 2> words{htonl(static_cast<std::uint32_t>(type)),
                                           htonl(static_cast<std::uint32_t>(argument))};
  Bytes bytes(sizeof words);
  std::memcpy(bytes.data(), words.data(), sizeof words);
  return bytes;
}

Bytes forces(std::int32_t count, const std::vector<std::int32_t>& atoms,
             const std::vector<float>& numbers) {
  Bytes bytes = packet(ImdType::forces, count);
  const auto* a = reinterpret_cast<const std::byte*>(atoms.data());
  const auto* f = reinterpret_cast<const std::byte*>(numbers.data());
  bytes.insert(bytes.end(), a, a + 4 * atoms.size());
  bytes.insert(bytes.end(), f, f + 4 * numbers.size());
  return bytes;
}

void send_all(const Socket& socket, const Bytes& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::send(static_cast<int>(socket.get()), bytes.data() + sent,
                                 bytes.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

Bytes receive(const Socket& socket, std::size_t count) {
  Bytes bytes(count);
  std::size_t got = 0;
  while (got < count) {
    const ssize_t more = recv(static_cast<int>(socket.get()), bytes.data() + got, count - got, 0);
    if (more <= 0) break;
    got += static_cast<std::size_t>(more);
  }
  bytes.resize(got);
  return bytes;
}

Bytes receive_all(const Socket& socket) {
  Bytes all;
  for (Bytes some = receive(socket, 4096); !some.empty(); some = receive(socket, 4096))
    all = std::move(all) + some;
  return all;
}

}  // namespace pliant::test
