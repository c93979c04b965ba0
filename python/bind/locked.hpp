// SPDX-License-Identifier: MIT
// Objects that use HDF5, for Python: shared by threads, without waiting while the GIL is held.
#pragma once

#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "bind.hpp"
#include "pliant/base/system/process.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"

namespace pliant::python {

/// An object and the lock of its calls. HDF5 has one lock for all files, and the library may log
/// while it holds that lock, which needs the GIL: a thread must therefore release the GIL before it
/// waits for that lock. A forked process must not touch the object, because a thread that used it
/// at that time never ends there.
template <class Object>
class Locked {
 public:
  /// Does not need the GIL.
  template <class... Arguments>
  explicit Locked(const Arguments&... arguments)
      : object_(std::make_unique<Object>(arguments...)) {}

  /// Needs the GIL, and releases it.
  ~Locked() {
    if (is_forked()) {
      static_cast<void>(object_.release());
      return;
    }
    const nb::gil_scoped_release no_gil;
    object_.reset();
  }

  /// Calls `use` with the object, one thread at a time. The GIL must not be held.
  template <class Use>
  auto use(Use&& use) {
    if (is_forked())
      throw std::runtime_error("it belongs to process " + std::to_string(owner_) +
                               ": a forked process opens files of its own");
    const std::lock_guard one_at_a_time(mutex_);
    return use(*object_);
  }

  /// The same for callers that hold the GIL, which is released meanwhile.
  template <class Use>
  auto call(Use&& use) {
    const nb::gil_scoped_release no_gil;
    return this->use(use);
  }

 private:
  bool is_forked() const { return process_id() != owner_; }

  const int owner_ = process_id();
  std::mutex mutex_;
  std::unique_ptr<Object> object_;
};

/// The member function `Call`, which takes nothing, as a function of the locked object.
template <class Object, auto Call>
auto locked() {
  return [](Locked<Object>& self) {
    return self.call([](Object& object) { return (object.*Call)(); });
  };
}

using LockedRecorder = Locked<H5mdRecorder>;
using LockedReader = Locked<H5mdReader>;

}  // namespace pliant::python
