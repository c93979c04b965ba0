// SPDX-License-Identifier: MIT
// Counters: sweeps a resolve, and the time by bar of a whole resolve and of one sweep. Whether the
// bars are whole is measured here, not asked of the technique.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "bench/bench.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/random.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/resolve/walkers.hpp"

namespace pliant::bench {
namespace {

constexpr double displacement = 0.1;  // Angstrom
constexpr std::uint64_t conformers = 16;

std::vector<Vec3> displaced(const Molecule& molecule, std::uint64_t seed) {
  std::vector<Vec3> positions = molecule.structure.positions;
  for (std::size_t joint = 0; joint < positions.size(); ++joint) {
    RandomSequence random({.seed = seed, .domain = Domain::displacement, .joint = joint});
    positions[joint] += displacement * random.direction();
  }
  return positions;
}

std::vector<std::vector<Vec3>> broken(const Molecule& molecule) {
  std::vector<std::vector<Vec3>> result;
  for (std::uint64_t seed = 0; seed < conformers; ++seed)
    result.push_back(displaced(molecule, seed));
  return result;
}

void report(benchmark::State& state, std::size_t bars, std::int64_t sweeps,
            std::int64_t conformers_resolved) {
  using benchmark::Counter;
  const auto resolves = static_cast<double>(conformers_resolved);
  const auto all_bars = static_cast<double>(bars);
  const auto inverse_rate = static_cast<Counter::Flags>(Counter::kIsRate | Counter::kInvert);
  state.counters["sweeps"] = static_cast<double>(sweeps) / resolves;
  state.counters["per_bar"] = Counter(resolves * all_bars, inverse_rate);
  state.counters["per_bar_sweep"] = Counter(static_cast<double>(sweeps) * all_bars, inverse_rate);
}

void resolve_all(benchmark::State& state, const SharedMolecule& molecule,
                 const Technique& technique, double tolerance) {
  ResolveOptions options;
  options.tolerance.relative = tolerance;
  const auto starts = broken(*molecule);
  Resolver resolver(molecule->framework, technique, options);
  std::int64_t sweeps = 0;
  std::size_t next = 0;
  std::vector<Vec3> positions;
  for (auto unused : state) {
    positions = starts[next++ % conformers];
    sweeps += resolver.resolve(positions).sweeps;
  }
  if (measure(molecule->framework, positions).max_relative > tolerance * (1 + 1e-9))
    state.SkipWithError("not resolved");
  report(state, molecule->framework.bar_count(), sweeps, state.iterations());
}

/// All conformers in one call, in lanes or one after the other; counts are of one conformer.
void resolve_walkers(benchmark::State& state, const SharedMolecule& molecule,
                     const Technique& technique, double tolerance, bool lanes) {
  ResolveOptions options;
  options.tolerance.relative = tolerance;
  const auto starts = broken(*molecule);
  auto positions = starts;
  std::vector<WalkerPositions> walkers;
  for (std::uint64_t k = 0; k < conformers; ++k)
    walkers.push_back({k, positions[k], molecule->structure.positions});
  std::vector<ResolveSummary> summaries(conformers);
  WalkerResolver resolver(molecule->framework, technique, options, {lanes, {}});
  std::int64_t sweeps = 0, resolved = 0;
  for (auto unused : state) {
    for (std::uint64_t k = 0; k < conformers; ++k)
      std::copy(starts[k].begin(), starts[k].end(), positions[k].begin());
    const auto start = std::chrono::steady_clock::now();
    resolver.resolve(walkers, summaries, 0, 0, Measured::nothing);
    state.SetIterationTime(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    for (const ResolveSummary& summary : summaries) sweeps += summary.sweeps;
    resolved += conformers;
  }
  for (const auto& conformer : positions)
    if (measure(molecule->framework, conformer).max_relative > tolerance * (1 + 1e-9))
      state.SkipWithError("not resolved");
  state.SetLabel(std::string(resolver.level()));
  report(state, molecule->framework.bar_count(), sweeps, resolved);
}

bool applies(const TechniqueEntry& row, const Framework& framework) {
  try {
    check(Technique{std::string(row.name)}, framework);
    return true;
  } catch (const OptionError&) {
    return false;
  }
}

void add(const SharedMolecule& molecule, const Technique& technique, double tolerance,
         const std::string& rest) {
  const std::string name = "resolve/" + molecule->name + "/" + technique.name + rest;
  benchmark::RegisterBenchmark(name.c_str(), resolve_all, molecule, technique, tolerance);
}

void add_walkers(const SharedMolecule& molecule, const Technique& technique) {
  for (const bool lanes : {true, false}) {
    const std::string name = "walkers/" + molecule->name + "/" + technique.name +
                             (lanes ? "/lanes" : "/alone") + "/1e-10";
    benchmark::RegisterBenchmark(name.c_str(), resolve_walkers, molecule, technique, 1e-10, lanes)
        ->UseManualTime();
  }
}

}  // namespace

void add_resolve_benchmarks(const SharedMolecule& molecule) {
  for (const TechniqueEntry& row : techniques()) {
    if (!applies(row, molecule->framework)) continue;
    for (const double weighting : {0.5, 1.0}) {
      const Technique technique{std::string(row.name), weighting};
      const std::string part = row.has_weighting ? weighting == 1.0 ? "/1" : "/0.5" : "";
      add(molecule, technique, 1e-4, part + "/1e-4");
      add(molecule, technique, 1e-8, part + "/1e-8");
      if (!row.has_weighting) break;
    }
    if (row.make_lanes != nullptr) add_walkers(molecule, {std::string(row.name), 1.0});
  }
}

void add_angle_benchmarks(const SharedMolecule& molecule) {
  add(molecule, {"units"}, 1e-8, "/angles/1e-8");
}

}  // namespace pliant::bench
