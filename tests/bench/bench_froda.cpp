// SPDX-License-Identifier: MIT
// Frames that technique `froda` resolves by careful steps, one by one and eight at once in SIMD
// lanes, near pairs and contacts included. The counter per_frame is the time for one frame.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "bench/bench.hpp"
#include "pliant/model/model.hpp"
#include "pliant/resolve/bodies/pull/froda_lanes.hpp"
#include "pliant/resolve/bodies/pull/froda_solver.hpp"

namespace pliant::bench {
namespace {

constexpr std::size_t frame_count = 32;
constexpr double amplitude = 1.5, wave_number = 0.2;  // Angstrom, Angstrom^-1

/// A molecule's model, and frames that bend it in waves some 30 Angstrom long.
struct Frames {
  MolecularModel model;
  std::optional<BodyPlan> plan;
  std::vector<std::vector<Vec3>> targets, out;
  FrodaOptions options{.is_careful = true, .has_torsion_preferences = true};

  explicit Frames(const SharedMolecule& of)
      : model(build_model(of->structure, {.kind = usual_model(of->structure)})),
        plan(BodyPlan::make(model.framework)),
        out(frame_count, model.positions) {
    for (std::size_t frame = 0; frame < frame_count; ++frame) {
      targets.push_back(model.positions);
      for (Vec3& x : targets.back()) x += amplitude * wave(x, double(frame));
    }
  }

  static Vec3 wave(Vec3 x, double phase) {
    return {std::sin(wave_number * x.y + phase), std::sin(wave_number * x.z + 2.0 * phase),
            std::sin(wave_number * x.x + 3.0 * phase)};
  }

  void resolve_alone() {
    FrodaSolver solver(model.framework, *plan);
    for (std::size_t k = 0; k < frame_count; ++k)
      solver.resolve(model.positions, targets[k], out[k], options);
  }

  void resolve_in_lanes(const LaneKernels& kernels) {
    std::vector<FrodaJob> jobs;
    for (std::size_t k = 0; k < frame_count; ++k)
      jobs.push_back({{model.positions, targets[k]}, out[k]});
    FrodaLanes(model.framework, *plan, kernels).resolve(jobs, options);
  }
};

void count_frames(benchmark::State& state) {
  state.counters["per_frame"] =
      benchmark::Counter(double(frame_count) * double(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void time_alone(benchmark::State& state, const std::shared_ptr<Frames>& frames) {
  for (auto unused : state) frames->resolve_alone();
  count_frames(state);
}

void time_in_lanes(benchmark::State& state, const std::shared_ptr<Frames>& frames,
                   const LaneKernels* kernels) {
  for (auto unused : state) frames->resolve_in_lanes(*kernels);
  count_frames(state);
  const auto in_lanes = frames->out;
  frames->resolve_alone();
  if (in_lanes != frames->out) state.SkipWithError("frames in lanes differ from those alone");
}

}  // namespace

void add_froda_benchmarks(const SharedMolecule& molecule) {
  const auto frames = std::make_shared<Frames>(molecule);
  if (!frames->plan || !FrodaLanes::can_take(*frames->plan)) return;
  const std::string name = "froda/" + molecule->name;
  benchmark::RegisterBenchmark((name + "/alone").c_str(), time_alone, frames)
      ->Unit(benchmark::kMillisecond);
  for (const LaneKernels* kernels : lane_levels())
    benchmark::RegisterBenchmark((name + "/lanes_" + kernels->level).c_str(), time_in_lanes, frames,
                                 kernels)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace pliant::bench
