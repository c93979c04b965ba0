// SPDX-License-Identifier: MIT
// Access to the HDF5 library: owned identifiers, one lock, no messages, and reasons for errors.
// Only .cpp files of this folder include HDF5's own header.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace pliant {

/// An HDF5 identifier (hid_t) that closes itself.
class Hid {
 public:
  using Closer = int (*)(std::int64_t);

  Hid() = default;
  Hid(std::int64_t id, Closer closer) : id_(id), closer_(closer) {}
  Hid(Hid&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
  Hid& operator=(Hid&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(closer_, other.closer_);
    return *this;
  }
  ~Hid() { reset(); }

  operator std::int64_t() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }
  void reset() {
    if (id_ >= 0) closer_(std::exchange(id_, -1));
  }

 private:
  std::int64_t id_ = -1;
  Closer closer_ = nullptr;
};

/// While it lives, this thread alone uses HDF5, and HDF5 prints nothing. HDF5 as Debian builds it
/// is not thread-safe, so every public call that reaches it holds one. Throws FileError in a
/// process that was forked while another thread of its parent held one.
class Hdf5Session {
 public:
  Hdf5Session();
  ~Hdf5Session();
  Hdf5Session(const Hdf5Session&) = delete;
  Hdf5Session& operator=(const Hdf5Session&) = delete;

 private:
  std::unique_lock<std::recursive_mutex> lock_;
  int (*printer_)(std::int64_t, void*) = nullptr;
  void* printer_argument_ = nullptr;
};

/// Returns the innermost reason on HDF5's error stack, or "unknown reason".
std::string hdf5_reason();

/// Throws FileError("cannot `what`: `reason`").
[[noreturn]] void throw_hdf5_error(std::string_view what);

/// Returns `status`, the result of an HDF5 call. Throws FileError when it is negative.
template <class Status>
Status checked(Status status, std::string_view what) {
  if (status < 0) throw_hdf5_error(what);
  return status;
}

/// Returns a checked identifier that closes itself.
inline Hid owned(std::int64_t id, Hid::Closer closer, std::string_view what) {
  return {checked(id, what), closer};
}

}  // namespace pliant
