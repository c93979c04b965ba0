// SPDX-License-Identifier: MIT
// The recorder for Python: shared by threads, and never waited for with the GIL held.
#pragma once

#include <memory>
#include <mutex>

#include "bind.hpp"
#include "pliant/record/h5md_recorder.hpp"

namespace pliant::python {

/// One recorder and the lock of its calls. HDF5 has one lock for all files, under which warnings
/// are spoken, which takes the GIL: so whoever waits for that lock must have given up the GIL.
class SharedRecorder {
 public:
  /// Needs no GIL.
  SharedRecorder(const std::filesystem::path& path, const Framework& framework,
                 const H5mdHeader& header, const H5mdOptions& options)
      : recorder_(std::make_unique<H5mdRecorder>(path, framework, header, options)) {}

  /// Needs the GIL, which it gives up.
  ~SharedRecorder() {
    const nb::gil_scoped_release no_gil;
    recorder_.reset();
  }

  /// Calls `use` with the recorder and without the GIL, one thread at a time.
  template <class Use>
  auto with(Use use) {
    const std::lock_guard one_at_a_time(mutex_);
    return use(*recorder_);
  }

 private:
  std::mutex mutex_;
  std::unique_ptr<H5mdRecorder> recorder_;
};

}  // namespace pliant::python
