// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/force_recorder.hpp"

#include <algorithm>
#include <utility>

#include "pliant/run/force_settings.hpp"

namespace pliant {

ForceRecorder::ForceRecorder(const std::filesystem::path& path, bool overwrite,
                             const Framework& framework, ForceFile settings,
                             std::optional<double> held_back)
    : framework_(framework),
      forces_(std::move(settings)),
      file_(path, overwrite),
      held_back_(held_back) {
  if (!held_back) return;
  events_ = settings_of(forces_);
  events_.push_back({StartWalk{}});
  events_.push_back({HoldBack{*held_back}});
}

void ForceRecorder::record(const Push& push) {
  if (held_back_) return add_wander(events_, push.asked);
  const std::size_t before = forces_.pushes.size();
  forces_.pushes.insert(forces_.pushes.end(), push.forces.begin(), push.forces.end());
  if (push.forces.empty() && push.root_joint != no_joint)
    forces_.pushes.push_back({static_cast<Joint>(push.root_joint), push.force});
  forces_.counts.push_back(static_cast<std::int64_t>(forces_.pushes.size() - before));
}

void ForceRecorder::publish() {
  const auto is_one = [](std::int64_t count) { return count == 1; };
  if (std::ranges::all_of(forces_.counts, is_one)) forces_.counts.clear();
  file_.write(held_back_ ? write_force_events(events_, framework_, forces_.header)
                         : write_force_file(forces_, framework_));
  file_.publish();
}

ForceFile force_file_of(const RunOptions& options, ForceHeader header, bool is_counted) {
  ForceFile forces;
  forces.set(options.perturb_options, options.resolve.tolerance, options.resolve.max_sweeps);
  forces.settings = is_counted ? force_settings(options) : push_settings(options);
  forces.header = std::move(header);
  return forces;
}

}  // namespace pliant
