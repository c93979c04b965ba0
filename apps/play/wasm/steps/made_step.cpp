// SPDX-License-Identifier: MIT
#include "steps/made_step.hpp"

#include <chrono>
#include <functional>
#include <span>

namespace pliant::play {
namespace {

/// Calls a function at the end of a block, whatever ends it.
class AtEnd {
 public:
  explicit AtEnd(std::function<void()> work) : work_(std::move(work)) {}
  AtEnd(const AtEnd&) = delete;
  AtEnd& operator=(const AtEnd&) = delete;
  ~AtEnd() { work_(); }

 private:
  std::function<void()> work_;
};

}  // namespace

StepReport make_step(SteeredWalk& walk, StepClock& clock, const std::function<Frame()>& step) {
  StepReport report;
  walk.look_at_push([&](std::span<const Vec3> positions) {
    report.pushed.assign(positions.begin(), positions.end());
  });
  const AtEnd leave([&] {
    walk.look_at_push({});
    clock.end();
  });
  clock.begin();
  const auto start = std::chrono::steady_clock::now();
  report.frame = step();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.resolved = walk.resolved();
  return report;
}

StepReport make_watched(SteeredWalk& walk, const std::function<void(const RepairedBar&)>& on_bar,
                        const std::function<StepReport()>& step) {
  walk.watch(on_bar);
  const AtEnd leave([&] { walk.watch({}); });
  return step();
}

}  // namespace pliant::play
