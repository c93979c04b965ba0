// SPDX-License-Identifier: MIT
#include "pliant/laboratory/force_recorder.hpp"

#include <algorithm>
#include <utility>

namespace pliant {

ForceRecorder::ForceRecorder(const std::filesystem::path& path, bool overwrite,
                             const Framework& framework, ForceFile settings,
                             bool only_counts_random)
    : framework_(framework),
      forces_(std::move(settings)),
      file_(path, overwrite),
      only_counts_random_(only_counts_random) {}

void ForceRecorder::record(const Push& push) {
  if (only_counts_random_ && push.forces.size() == 1) {
    if (forces_.counts.empty() || forces_.counts.back() >= 0) forces_.counts.push_back(0);
    --forces_.counts.back();
    return;
  }
  const std::size_t before = forces_.pushes.size();
  forces_.pushes.insert(forces_.pushes.end(), push.forces.begin(), push.forces.end());
  if (push.forces.empty() && push.root_joint != no_joint)
    forces_.pushes.push_back({static_cast<Joint>(push.root_joint), push.force});
  forces_.counts.push_back(static_cast<std::int64_t>(forces_.pushes.size() - before));
}

void ForceRecorder::publish() {
  const auto is_one = [](std::int64_t count) { return count == 1; };
  if (std::ranges::all_of(forces_.counts, is_one)) forces_.counts.clear();
  file_.write(write_force_file(forces_, framework_));
  file_.publish();
}

}  // namespace pliant
