// SPDX-License-Identifier: MIT
#include "pliant/laboratory/force_recorder.hpp"

#include <utility>

namespace pliant {

ForceRecorder::ForceRecorder(const std::filesystem::path& path, bool overwrite,
                             const Framework& framework, ForceFile settings)
    : framework_(framework), forces_(std::move(settings)), file_(path, overwrite) {}

void ForceRecorder::record(const Push& push) {
  forces_.pushes.push_back({static_cast<Joint>(push.root_joint), push.force});
}

void ForceRecorder::publish() {
  file_.write(write_force_file(forces_, framework_));
  file_.publish();
}

}  // namespace pliant
