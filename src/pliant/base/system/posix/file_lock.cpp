// SPDX-License-Identifier: MIT
#include "pliant/base/system/file_lock.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace pliant {
namespace {

// Locked bytes, where no file has data. The second tells who holds the first: only a traditional
// lock knows its process, but it does not hold between two recorders of one process.
constexpr off_t writer_byte = off_t{1} << 62;
constexpr off_t process_byte = writer_byte + 1;

struct flock write_lock(off_t byte) {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = byte;
  lock.l_len = 1;
  return lock;
}

}  // namespace

Locking lock_for_writing(int descriptor) {
  struct flock writer = write_lock(writer_byte);
  if (::fcntl(descriptor, F_OFD_SETLK, &writer) != 0)
    return errno == EAGAIN || errno == EACCES ? Locking::held_by_another : Locking::has_no_locks;
  struct flock process = write_lock(process_byte);
  ::fcntl(descriptor, F_SETLK, &process);
  return Locking::locked;
}

bool is_being_written(int descriptor) {
  struct flock lock = write_lock(writer_byte);
  return ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

std::string lock_holder(int descriptor) {
  struct flock lock = write_lock(process_byte);
  const bool is_known =
      ::fcntl(descriptor, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK && lock.l_pid > 0;
  return is_known ? "process " + std::to_string(lock.l_pid) : "another recorder";
}

bool locks_keep_from_reading() { return false; }

}  // namespace pliant
