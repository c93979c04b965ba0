// SPDX-License-Identifier: MIT
// Where the time of eight walkers in lanes goes: each kernel of technique `blocks` alone, at each
// level of instructions. The counter per_bar is the time for one bar of one walker.
// "roots" is the limit of `carry`: bridges that do not wait for each other, in the nearest cache,
// so that nothing is left but the square root and the division of each.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "bench/bench.hpp"
#include "pliant/base/random.hpp"
#include "pliant/resolve/blocks/block_solver.hpp"
#include "pliant/resolve/blocks/outward_plan.hpp"
#include "pliant/resolve/lanes/lane_method.hpp"

namespace pliant::bench {
namespace {

constexpr double displacement = 0.1;  // Angstrom
constexpr Tolerance tolerance{1e-10};

/// One outward pass of eight broken conformers, in pieces.
struct Pieces {
  SharedMolecule molecule;
  std::vector<LaneBar> bars;
  OutwardPlanner planner;
  BlockSolver blocks;
  LaneScratch scratch;
  std::vector<OutwardStep> entries;  ///< into blocks
  std::vector<LaneBar> bridges;
  std::vector<std::vector<Vec3>> conformers;
  std::vector<LaneVector> positions;

  explicit Pieces(const SharedMolecule& of)
      : molecule(of),
        bars(lane_bars(of->framework, tolerance)),
        planner(of->framework),
        blocks(of->framework, {"blocks"}, tolerance, planner.blocks()),
        conformers(lane_count, of->structure.positions),
        positions(of->framework.joint_count()) {
    for (std::uint32_t block = 0; block < blocks.count(); ++block)
      scratch.fit(blocks.pattern(block));
    std::vector<OutwardStep> steps;
    planner.plan(0, steps);
    for (const OutwardStep& step : steps) {
      if (step.block != no_block) {
        entries.push_back(step);
      } else {
        const double rest = of->framework.rest_lengths()[step.bar];
        bridges.push_back(lane_bar(step.near, step.far, rest, tolerance.of(rest)));
      }
    }
    push();
  }

  void push() {
    for (std::uint64_t lane = 0; lane < lane_count; ++lane) {
      std::vector<Vec3> directions(conformers[lane].size());
      random_directions({.seed = lane, .domain = Domain::displacement}, false, directions);
      for (std::size_t joint = 0; joint < directions.size(); ++joint)
        conformers[lane][joint] += displacement * directions[joint];
    }
  }

  void gather(const LaneKernels& kernels) {
    const double* rows[lane_count];
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      rows[lane] = reinterpret_cast<const double*>(conformers[lane].data());
    kernels.gather(rows, 3 * positions.size(), reinterpret_cast<LaneValue*>(positions.data()));
  }

  void scatter(const LaneKernels& kernels) {
    double* rows[lane_count];
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      rows[lane] = reinterpret_cast<double*>(conformers[lane].data());
    kernels.scatter(reinterpret_cast<const LaneValue*>(positions.data()), 3 * positions.size(),
                    rows);
  }

  void carry(const LaneKernels& kernels) {
    benchmark::DoNotOptimize(kernels.carry({bridges.data(), bridges.size()}, positions.data()));
  }

  void newton(const LaneKernels& kernels) {
    for (const OutwardStep& step : entries)
      benchmark::DoNotOptimize(kernels.block_newton(blocks.hold(step.block, step.near),
                                                    scratch.room(), positions.data()));
  }

  void confirm_whole(const LaneKernels& kernels) {
    benchmark::DoNotOptimize(kernels.confirm_whole({bars.data(), bars.size()}, positions.data()));
  }

  void measure(const LaneKernels& kernels) {
    benchmark::DoNotOptimize(kernels.measure({bars.data(), bars.size()}, positions.data(), false));
  }
};

using Piece = void (Pieces::*)(const LaneKernels&);

/// `piece` from broken or whole positions in lanes, which are put back outside the clock.
void time_piece(benchmark::State& state, const SharedMolecule& molecule, const LaneKernels* kernels,
                Piece piece, bool whole) {
  Pieces pieces(molecule);
  pieces.gather(*kernels);
  if (whole) {
    pieces.carry(*kernels);
    pieces.newton(*kernels);
  }
  const std::vector<LaneVector> start = pieces.positions;
  for (auto unused : state) {
    state.PauseTiming();
    pieces.positions = start;
    state.ResumeTiming();
    (pieces.*piece)(*kernels);
  }
  const double bars = double(molecule->framework.bar_count() * lane_count);
  state.counters["per_bar"] = benchmark::Counter(
      bars * double(state.iterations()), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void time_roots(benchmark::State& state, const LaneKernels* kernels) {
  constexpr std::uint32_t count = 64;
  std::vector<LaneVector> positions(count + 1);
  std::vector<LaneBar> star;
  for (std::uint32_t joint = 1; joint <= count; ++joint) {
    positions[joint].x = {{1, 2, 3, 4, 5, 6, 7, 8}};
    star.push_back(lane_bar(0, joint, 1.5, 1.5e-10));
  }
  for (auto unused : state)
    benchmark::DoNotOptimize(kernels->carry({star.data(), star.size()}, positions.data()));
  state.counters["per_bar"] =
      benchmark::Counter(double(count * lane_count) * double(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

}  // namespace

void add_lane_benchmarks(const SharedMolecule& molecule) {
  const struct {
    const char* name;
    Piece piece;
    bool whole;
  } pieces[] = {
      {"gather", &Pieces::gather, false},  {"carry", &Pieces::carry, false},
      {"newton", &Pieces::newton, false},  {"confirm_whole", &Pieces::confirm_whole, true},
      {"measure", &Pieces::measure, true}, {"scatter", &Pieces::scatter, false}};
  for (const LaneKernels* kernels : lane_levels()) {
    const std::string limit = "lanes/" + molecule->name + "/roots/" + std::string(kernels->level);
    benchmark::RegisterBenchmark(limit.c_str(), time_roots, kernels);
    for (const auto& [name, piece, whole] : pieces) {
      const std::string full =
          "lanes/" + molecule->name + "/" + name + "/" + std::string(kernels->level);
      benchmark::RegisterBenchmark(full.c_str(), time_piece, molecule, kernels, piece, whole);
    }
  }
}

}  // namespace pliant::bench
