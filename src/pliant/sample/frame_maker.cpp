// SPDX-License-Identifier: MIT
#include "pliant/sample/frame_maker.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

#include "pliant/framework/measures/residual.hpp"

namespace pliant {
namespace {

constexpr int most_redraws = 20;

FrodaOptions blind() {
  FrodaOptions options;
  options.has_torsion_preferences = true;
  return options;
}

FrodaOptions careful() {
  FrodaOptions options = blind();
  options.is_careful = true;
  options.conjugate_gradients = 3;
  options.leg = 2.5;
  options.legs_a_look = 2;
  options.bound = 2.0;
  options.last_weight = 200.0;
  return options;
}

FrodaOptions patient() {
  FrodaOptions options = careful();
  options.conjugate_gradients = 6;
  options.leg = 0.7;
  options.legs_a_look = 1;
  options.bound = 1.5;
  options.last_steps = 200;
  return options;
}

/// Seconds of this thread alone; of the clock on the wall where the system knows no other
/// (WebAssembly).
double thread_seconds() {
  timespec now{};
#ifdef CLOCK_THREAD_CPUTIME_ID
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
#else
  clock_gettime(CLOCK_MONOTONIC, &now);
#endif
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// A frame to be made, in the memory of one that was shown.
void empty(MadeFrame& frame, std::size_t joints) {
  std::vector<Vec3> positions = std::move(frame.positions);
  frame = MadeFrame{};
  frame.positions = std::move(positions);
  frame.positions.resize(joints);
}

double rms_distance(std::span<const Vec3> one, std::span<const Vec3> other) {
  double sum = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) sum += norm_squared(one[k] - other[k]);
  return std::sqrt(sum / double(std::max<std::size_t>(one.size(), 1)));
}

}  // namespace

FrameMaker::FrameMaker(const Framework& framework, const BodyPlan& plan, const Sampler& sampler)
    : framework_(framework), sampler_(sampler), solver_(framework, plan) {
  if (sampler.steps_a_frame() == 1 && FrodaLanes::can_take(plan))
    lanes_ = std::make_unique<FrodaLanes>(framework, plan);
}

void FrameMaker::make(std::int64_t number, std::span<const Vec3> start, MadeFrame& out) {
  const double begun = thread_seconds();
  empty(out, start.size());
  now_.assign(start.begin(), start.end());
  for (int step = 0; step < sampler_.steps_a_frame(); ++step) {
    out.is_made = make_step(number, step, now_, out);
    if (!out.is_made) break;
    now_ = out.positions;
  }
  finish(out);
  out.cpu_seconds = thread_seconds() - begun;
}

void FrameMaker::make_many(std::int64_t first, std::span<const Vec3> start,
                           std::span<MadeFrame> out) {
  const double begun = thread_seconds();
  requests_.resize(out.size());
  jobs_.clear();
  for (std::size_t k = 0; k < out.size(); ++k) {
    empty(out[k], start.size());
    FrameRequest& request = requests_[k];
    sampler_.ask(first + static_cast<std::int64_t>(k), 0, 0, start, request);
    jobs_.push_back({push_of(request, start), out[k].positions});
  }
  lanes_->resolve(jobs_, careful());
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k].result = jobs_[k].result;
    out[k].steps = out[k].result.steps;
    std::swap(request_, requests_[k]);
    out[k].is_made = out[k].result.is_whole || rescue(from(request_, start), out[k]) ||
                     draw_again(first + static_cast<std::int64_t>(k), 0, start, out[k]);
    finish(out[k]);
  }
  const double share = (thread_seconds() - begun) / double(out.size());
  for (MadeFrame& frame : out) frame.cpu_seconds = share;
}

/// Completes a frame that is made: what the last request said, and how whole its bars are.
void FrameMaker::finish(MadeFrame& out) const {
  if (!out.is_made) return;
  out.limits_off = request_.limits_off;
  out.drawn_by = request_.drawn_by;
  out.off_target = rms_distance(out.positions, request_.targets);
  measure_bars(out);
  out.is_made = out.max_residual <= most_residual && std::isfinite(out.off_target);
}

std::span<const Vec3> FrameMaker::from(const FrameRequest& request, std::span<const Vec3> now) {
  return request.from.empty() ? now : std::span<const Vec3>(request.from);
}

FrodaPush FrameMaker::push_of(const FrameRequest& request, std::span<const Vec3> now) {
  return {from(request, now), request.targets, request.limits_off,
          request.course.at ? &request.course : nullptr};
}

/// The draw itself, by careful steps, else rescued; then drawn again.
bool FrameMaker::make_step(std::int64_t number, int step, std::span<const Vec3> now,
                           MadeFrame& out) {
  sampler_.ask(number, step, 0, now, request_);
  const std::span<const Vec3> start = from(request_, now);
  return resolve(start, careful(), out) || rescue(start, out) || draw_again(number, step, now, out);
}

bool FrameMaker::draw_again(std::int64_t number, int step, std::span<const Vec3> now,
                            MadeFrame& out) {
  for (int attempt = 1; attempt <= most_redraws; ++attempt) {
    ++out.redraws;
    sampler_.ask(number, step, attempt, now, request_);
    const std::span<const Vec3> start = from(request_, now);
    if (resolve(start, careful(), out) || rescue(start, out)) return true;
  }
  return false;
}

/// Rescues a frame by blind steps, else by many small ones.
bool FrameMaker::rescue(std::span<const Vec3> from, MadeFrame& out) {
  out.is_rescued = true;
  return resolve(from, blind(), out) || resolve(from, patient(), out);
}

bool FrameMaker::resolve(std::span<const Vec3> now, const FrodaOptions& options, MadeFrame& out) {
  out.result = solver_.resolve(push_of(request_, now), out.positions, options);
  out.steps += out.result.steps;
  return out.result.is_whole;
}

void FrameMaker::measure_bars(MadeFrame& out) const {
  double squares = 0.0;
  const auto bars = framework_.bars();
  for (BarIndex k = 0; k < bars.size(); ++k) {
    const double rest = framework_.rest_lengths()[k];
    const double share =
        std::abs(residual(out.positions[bars[k].a], out.positions[bars[k].b], rest)) / rest;
    squares += share * share;
    if (!(share > out.max_residual)) continue;
    out.max_residual = share;
    out.worst_bar = k;
  }
  if (!bars.empty()) out.rms_residual = std::sqrt(squares / double(bars.size()));
}

}  // namespace pliant
