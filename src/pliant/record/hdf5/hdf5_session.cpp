// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/hdf5_session.hpp"

#include <hdf5.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <thread>
#include <type_traits>

#include "pliant/base/error.hpp"
#include "pliant/base/system/process.hpp"

namespace pliant {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>, "Hid holds what HDF5 calls hid_t");

/// The lock of HDF5. A process that is forked while another thread uses HDF5 gets it as that
/// thread has it, for ever: it waits for the thread a moment before, and does without HDF5 after.
struct Hdf5Lock {
  std::recursive_mutex mutex;
  bool is_held_for_fork = false;
  bool is_lost = false;  // HDF5 was in use when this process was forked
};

Hdf5Lock& hdf5_lock();

void before_fork() {
  using std::chrono::steady_clock;
  constexpr std::chrono::milliseconds patience{500}, pause{1};
  const auto end = steady_clock::now() + patience;
  bool is_held = hdf5_lock().mutex.try_lock();
  while (!is_held && steady_clock::now() < end) {
    std::this_thread::sleep_for(pause);
    is_held = hdf5_lock().mutex.try_lock();
  }
  hdf5_lock().is_held_for_fork = is_held;
}

void after_fork_in_parent() {
  if (hdf5_lock().is_held_for_fork) hdf5_lock().mutex.unlock();
}

/// The lock knows its thread by a number that the forked process has no more.
void after_fork_in_child() {
  hdf5_lock().is_lost = !hdf5_lock().is_held_for_fork || hdf5_lock().is_lost;
  std::construct_at(&hdf5_lock().mutex);
}

/// The lock is never destroyed: exit handlers may still look at it.
Hdf5Lock& hdf5_lock() {
  alignas(Hdf5Lock) static std::array<std::byte, sizeof(Hdf5Lock)> room;
  static Hdf5Lock* lock = [] {
    call_around_fork(before_fork, after_fork_in_parent, after_fork_in_child);
    return std::construct_at(reinterpret_cast<Hdf5Lock*>(room.data()));
  }();
  return *lock;
}

/// Keeps the description that the walk meets first, which is the innermost one.
herr_t keep_innermost(unsigned, const H5E_error2_t* error, void* text) {
  auto& reason = *static_cast<std::string*>(text);
  if (reason.empty() && error->desc != nullptr) reason = error->desc;
  return 0;
}

}  // namespace

Hdf5Session::Hdf5Session() : lock_(hdf5_lock().mutex) {
  if (hdf5_lock().is_lost)
    throw FileError("HDF5 was in use when this process was forked: start processes with spawn");
  H5Eget_auto2(H5E_DEFAULT, &printer_, &printer_argument_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Session::~Hdf5Session() { H5Eset_auto2(H5E_DEFAULT, printer_, printer_argument_); }

std::string hdf5_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  return reason.empty() ? "unknown reason" : reason;
}

void throw_hdf5_error(std::string_view what) {
  throw FileError("cannot " + std::string(what) + ": " + hdf5_reason());
}

}  // namespace pliant
