// SPDX-License-Identifier: MIT
// Locks that say: this file is being written.
#pragma once

#include <cstdint>
#include <string>

namespace pliant {

enum class Locking : std::uint8_t { locked, held_by_another, has_no_locks };

/// Locks an open file for one writer, until its descriptor is closed. Two descriptors of one
/// process exclude each other as those of two processes do.
///
/// The lock is on a byte far beyond the end of the file, which conflicts neither with readers nor
/// with HDF5's own locks (flock). POSIX: an open file description lock (F_OFD_SETLK). File systems
/// without locks, as some network ones are, give no protection: `has_no_locks`.
Locking lock_for_writing(int descriptor);

/// Whether another descriptor holds that lock.
bool is_being_written(int descriptor);

/// Who holds it: "process 123", or "another recorder" where the system does not say.
std::string lock_holder(int descriptor);

/// Whether locks of others keep a program from reading, as on Windows, or are agreements only.
bool locks_keep_from_reading();

}  // namespace pliant
