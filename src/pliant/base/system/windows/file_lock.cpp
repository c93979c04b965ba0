// SPDX-License-Identifier: MIT
#include "pliant/base/system/file_lock.hpp"

#include <windows.h>

#include "pliant/base/system/windows/windows_handles_internal.hpp"

namespace pliant {
namespace {

/// The byte that is locked, where no file has data: others cannot read a locked one.
OVERLAPPED writer_byte() {
  OVERLAPPED place{};
  place.OffsetHigh = DWORD{1} << 30;
  return place;
}

Locking lock(HANDLE handle) {
  OVERLAPPED place = writer_byte();
  constexpr DWORD at_once = LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY;
  if (::LockFileEx(handle, at_once, 0, 1, 0, &place)) return Locking::locked;
  const DWORD error = ::GetLastError();
  const bool is_held = error == ERROR_LOCK_VIOLATION || error == ERROR_IO_PENDING;
  return is_held ? Locking::held_by_another : Locking::has_no_locks;
}

}  // namespace

Locking lock_for_writing(int descriptor) { return lock(handle_of(descriptor)); }

bool is_being_written(int descriptor) {
  const HANDLE handle = handle_of(descriptor);
  const Locking locking = lock(handle);
  OVERLAPPED place = writer_byte();
  if (locking == Locking::locked) ::UnlockFileEx(handle, 0, 1, 0, &place);
  return locking == Locking::held_by_another;
}

std::string lock_holder(int) { return "another recorder"; }

bool locks_keep_from_reading() { return true; }

}  // namespace pliant
