// SPDX-License-Identifier: MIT
#include "pliant/sample/frame_maker.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "pliant/base/superposition.hpp"
#include "pliant/framework/residual.hpp"

namespace pliant {
namespace {

constexpr int most_redraws = 20;
/// Bars are whole to rounding by how units move: more is an error, and no frame (share of length).
constexpr double most_residual = 1e-9;

FrodaOptions blind() {
  FrodaOptions options;
  options.has_torsion_preferences = true;
  return options;
}

FrodaOptions careful() {
  FrodaOptions options = blind();
  options.is_careful = true;
  return options;
}

FrodaOptions patient() {
  FrodaOptions options = careful();
  options.conjugate_gradients = 6;
  options.leg = 0.7;
  options.last_steps = 200;
  return options;
}

/// Of this thread alone; of the wall where the system knows no other clock (WebAssembly).
double thread_seconds() {
  timespec now{};
#ifdef CLOCK_THREAD_CPUTIME_ID
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
#else
  clock_gettime(CLOCK_MONOTONIC, &now);
#endif
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

double rms_distance(std::span<const Vec3> one, std::span<const Vec3> other) {
  double sum = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) sum += norm_squared(one[k] - other[k]);
  return std::sqrt(sum / double(std::max<std::size_t>(one.size(), 1)));
}

}  // namespace

FrameMaker::FrameMaker(const Framework& framework, const BodyPlan& plan, const Sampler& sampler)
    : framework_(framework), sampler_(sampler), solver_(framework, plan) {}

void FrameMaker::make(std::int64_t number, std::span<const Vec3> now, std::span<const Vec3> before,
                      MadeFrame& out) {
  const double begun = thread_seconds();
  out = MadeFrame{};
  out.positions.resize(now.size());
  now_.assign(now.begin(), now.end());
  before_.assign(before.begin(), before.end());
  for (int step = 0; step < sampler_.steps_a_frame(); ++step) {
    out.is_made = make_step(number, step, now_, before_, out);
    if (!out.is_made) break;
    before_.swap(now_);
    now_ = out.positions;
  }
  if (out.is_made) {
    out.limits_off = request_.limits_off;
    out.off_target = rms_distance(out.positions, request_.targets);
    measure_bars(out);
    out.is_made = out.max_residual <= most_residual;
  }
  if (sampler_.is_walk()) keep_in_place(now, out);
  out.cpu_seconds = thread_seconds() - begun;
}

/// A walk's frame lies on the one before: as a whole it would drift away.
void FrameMaker::keep_in_place(std::span<const Vec3> start, MadeFrame& out) const {
  out.before = before_;
  if (!out.is_made) return;
  const RigidMotion back = superposition(out.positions, start);
  for (Vec3& x : out.positions) x = back(x);
  for (Vec3& x : out.before) x = back(x);
}

/// The draw itself, by careful steps, else by blind ones, else by many small ones; then drawn
/// again.
bool FrameMaker::make_step(std::int64_t number, int step, std::span<const Vec3> now,
                           std::span<const Vec3> before, MadeFrame& out) {
  for (int attempt = 0; attempt <= most_redraws; ++attempt) {
    if (attempt > 0) ++out.redraws;
    sampler_.ask(number, step, attempt, now, before, request_);
    const std::span<const Vec3> from = request_.from.empty() ? now : request_.from;
    if (resolve(from, careful(), out)) return true;
    out.is_rescued = true;
    if (resolve(from, blind(), out) || resolve(from, patient(), out)) return true;
  }
  return false;
}

bool FrameMaker::resolve(std::span<const Vec3> now, const FrodaOptions& options, MadeFrame& out) {
  out.outcome = solver_.resolve(now, request_.targets, out.positions, options, request_.limits_off);
  out.steps += out.outcome.steps;
  return out.outcome.is_whole;
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
