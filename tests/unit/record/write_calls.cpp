// SPDX-License-Identifier: MIT
#include "unit/record/write_calls.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

namespace pliant::test {
namespace {
WriteWatch* watch = nullptr;

/// Whether the call must fail now.
bool fails(WriteWatch& now) {
  const long number = now.count++;
  return now.fail_at >= 0 && number >= now.fail_at;
}
}  // namespace

WriteWatch::WriteWatch() { watch = this; }
WriteWatch::~WriteWatch() { watch = nullptr; }

namespace {

ssize_t plain_pwrite(int file, const void* bytes, std::size_t size, off_t offset) {
  return ::syscall(SYS_pwrite64, file, bytes, size, offset);
}

ssize_t watched_pwrite(int file, const void* bytes, std::size_t size, off_t offset) {
  const bool first = watch->count == watch->fail_at;
  if (fails(*watch)) {
    if (first && watch->half && size > 1) return plain_pwrite(file, bytes, size / 2, offset);
    errno = watch->error;
    return -1;
  }
  if (watch->keep) {
    const auto* start = static_cast<const std::byte*>(bytes);
    watch->calls.push_back({offset, {start, start + size}, false});
  }
  return plain_pwrite(file, bytes, size, offset);
}

int watched_ftruncate(int file, off_t size) {
  if (fails(*watch)) return errno = watch->error, -1;
  if (watch->keep) watch->calls.push_back({size, {}, true});
  return static_cast<int>(::syscall(SYS_ftruncate, file, size));
}

}  // namespace
}  // namespace pliant::test

extern "C" {

int flock(int file, int operation) noexcept {
  if (pliant::test::NoLocks::error == 0)
    return static_cast<int>(::syscall(SYS_flock, file, operation));
  errno = pliant::test::NoLocks::error;
  return -1;
}

ssize_t pwrite(int file, const void* bytes, size_t size, off_t offset) {
  if (pliant::test::watch == nullptr) return pliant::test::plain_pwrite(file, bytes, size, offset);
  return pliant::test::watched_pwrite(file, bytes, size, offset);
}

int ftruncate(int file, off_t size) noexcept {
  if (pliant::test::watch == nullptr) return static_cast<int>(::syscall(SYS_ftruncate, file, size));
  return pliant::test::watched_ftruncate(file, size);
}
}
