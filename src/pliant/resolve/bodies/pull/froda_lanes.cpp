// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/pull/froda_lanes.hpp"

#include <algorithm>

namespace pliant {
namespace {

/// Bodies of eight frames beyond which lanes wait for memory.
constexpr std::size_t most_bodies = 4000;
/// So few remaining frames are faster one by one.
constexpr std::ptrdiff_t few = 2;

// Without registers of several numbers, as in WebAssembly, lanes would only move more memory.
#if defined(__wasm__) && !defined(__wasm_simd128__)
constexpr bool has_registers = false;
#else
constexpr bool has_registers = true;
#endif

bool asks_for_a_step(FrodaFrame& frame) {
  return frame.ask_for_careful_pull() || frame.ask_for_contacts();
}

}  // namespace

bool FrodaLanes::can_take(const BodyPlan& plan) {
  return has_registers && plan.cuts().empty() && !plan.bodies().empty() &&
         plan.bodies().size() <= most_bodies;
}

FrodaLanes::FrodaLanes(const Framework& framework, const BodyPlan& plan, const LaneKernels& kernels)
    : framework_(framework),
      plan_(plan),
      all_(plan),
      together_(plan, kernels),
      alone_(plan, all_) {}

void FrodaLanes::resolve(std::span<FrodaJob> jobs, const FrodaOptions& options) {
  for (;;) {
    const auto busy = std::count_if(lanes_.begin(), lanes_.end(),
                                    [&](Lane& lane) { return take_up(lane, jobs, options); });
    if (busy == 0) return;
    if (busy > few) {
      step_together();
      continue;
    }
    for (Lane& lane : lanes_)
      if (lane.job != nullptr) finish_alone(lane);
  }
}

/// Prepares the lane's next step, of its frame or the next one that waits; false: none is left.
bool FrodaLanes::take_up(Lane& lane, std::span<FrodaJob>& waiting, const FrodaOptions& options) {
  for (;;) {
    if (lane.job == nullptr) {
      if (waiting.empty()) return false;
      lane.job = &waiting.front();
      waiting = waiting.subspan(1);
      if (!lane.frame) lane.frame = std::make_unique<FrodaFrame>(framework_, plan_);
      lane.frame->begin(lane.job->push, options);
    }
    if (asks_for_a_step(*lane.frame)) return true;
    leave(lane);
  }
}

void FrodaLanes::step_together() {
  std::array<LaneStepFrame, lane_count> frames;
  for (std::size_t k = 0; k < lane_count; ++k)
    if (lanes_[k].job != nullptr)
      frames[k] = {lanes_[k].frame->positions().data(), &lanes_[k].frame->request()};
  together_.step(frames);
  for (Lane& lane : lanes_)
    if (lane.job != nullptr) lane.frame->note_step();
}

/// Finishes a frame whose next step is asked for already.
void FrodaLanes::finish_alone(Lane& lane) {
  do {
    alone_.step(lane.frame->positions(), lane.frame->request());
    lane.frame->note_step();
  } while (asks_for_a_step(*lane.frame));
  leave(lane);
}

/// Takes out a frame that asks for no more steps.
void FrodaLanes::leave(Lane& lane) {
  lane.job->result = lane.frame->finish(lane.job->out);
  lane.job = nullptr;
}

}  // namespace pliant
