// SPDX-License-Identifier: MIT
#include "support/damaged_files.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <new>

#include "pliant/base/error.hpp"

namespace pliant::test {
namespace {

/// Numbers of one damage.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15 + 1) {}
  std::uint64_t below(std::uint64_t most) { return next() % most; }
  std::uint64_t next() {  // splitmix64
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
  }

 private:
  std::uint64_t state_;
};

std::string number_bytes(std::uint64_t number) {
  std::string bytes;
  for (int k = 0; k < 8; ++k) bytes += static_cast<char>(number >> 8 * k);
  return bytes;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_shadow = true;  // which takes terabytes of addresses
#else
constexpr bool has_shadow = false;
#endif

[[noreturn]] void read_and_leave(const std::function<void()>& read, unsigned seconds) {
  constexpr rlim_t most_bytes = rlim_t{1} << 30;
  const rlimit none{0, 0}, memory{most_bytes, most_bytes};
  ::setrlimit(RLIMIT_CORE, &none);
  if (!has_shadow) ::setrlimit(RLIMIT_AS, &memory);
  const rlimit time{seconds, seconds};
  ::setrlimit(RLIMIT_CPU, &time);
  try {
    read();
  } catch (const Error&) {
  } catch (const std::bad_alloc&) {
    ::_exit(2);
  } catch (...) {
    ::_exit(3);
  }
  ::_exit(0);
}

}  // namespace

std::string with_a_flip(const std::string& bytes, std::uint64_t number) {
  Numbers numbers(number);
  std::string flipped = bytes;
  flipped[numbers.below(bytes.size())] ^= static_cast<char>(1 << numbers.below(8));
  return flipped;
}

std::string with_a_damage(const std::string& bytes, std::uint64_t number) {
  Numbers numbers(~number);
  std::string damaged = bytes;
  const std::size_t length = std::size_t{1} << numbers.below(10);
  const std::size_t place = numbers.below(bytes.size()) / 8 * 8;
  const std::size_t other = numbers.below(bytes.size()) / 8 * 8;
  switch (numbers.below(6)) {
    case 0:
      return damaged.replace(place, length, bytes.substr(other, length)).substr(0, bytes.size());
    case 1:
      return damaged.replace(place, length, length, '\0').substr(0, bytes.size());
    case 2:
      return damaged.replace(place, length, length, '\xff').substr(0, bytes.size());
    case 3:
      return damaged.replace(place, 8, number_bytes(numbers.next() >> numbers.below(64)));
    case 4:  // an address or a length that can be
      return damaged.replace(place, 8, number_bytes(other));
    default:
      return damaged.substr(0, other);
  }
}

std::string death_of(const std::function<void()>& read, unsigned seconds) {
  const pid_t child = ::fork();
  if (child == 0) read_and_leave(read, seconds);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  const int code = WEXITSTATUS(status);
  return code == 0 ? "" : code == 2 ? "out of memory" : "ended with " + std::to_string(code);
}

}  // namespace pliant::test
