// SPDX-License-Identifier: MIT
// Objects that use HDF5, for Python: shared by threads, and never waited for with the GIL held.
#pragma once

#include <unistd.h>

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "bind.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"

namespace pliant::python {

/// An object and the lock of its calls. HDF5 has one lock for all files, under which the library
/// speaks, which takes the GIL: so whoever waits for that lock must have given up the GIL. A forked
/// process must leave the object alone: whoever used it in that moment never ends here.
template <class Object>
class Locked {
 public:
  /// Needs no GIL.
  template <class... Arguments>
  explicit Locked(const Arguments&... arguments)
      : object_(std::make_unique<Object>(arguments...)) {}

  /// Needs the GIL, which it gives up.
  ~Locked() {
    if (is_forked()) {
      static_cast<void>(object_.release());
      return;
    }
    const nb::gil_scoped_release no_gil;
    object_.reset();
  }

  /// Calls `use` with the object, one thread at a time. Needs the GIL not to be held.
  template <class Use>
  auto use(Use&& use) {
    if (is_forked())
      throw std::runtime_error("it belongs to process " + std::to_string(owner_) +
                               ": a forked process opens files of its own");
    const std::lock_guard one_at_a_time(mutex_);
    return use(*object_);
  }

  /// The same for who holds the GIL, which is given up meanwhile.
  template <class Use>
  auto call(Use&& use) {
    const nb::gil_scoped_release no_gil;
    return this->use(use);
  }

 private:
  bool is_forked() const { return ::getpid() != owner_; }

  const pid_t owner_ = ::getpid();
  std::mutex mutex_;
  std::unique_ptr<Object> object_;
};

using LockedRecorder = Locked<H5mdRecorder>;
using LockedReader = Locked<H5mdReader>;

}  // namespace pliant::python
