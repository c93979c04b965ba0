// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "bench/bench.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"

namespace pliant::bench {
namespace {

void per_atom(benchmark::State& state, std::size_t atoms) {
  const auto total = static_cast<double>(state.iterations()) * static_cast<double>(atoms);
  state.counters["per_atom"] =
      benchmark::Counter(total, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void read(benchmark::State& state, const SharedMolecule& molecule) {
  for (auto unused : state) benchmark::DoNotOptimize(read_structure(molecule->file));
  per_atom(state, molecule->structure.size());
}

void perceive(benchmark::State& state, const SharedMolecule& molecule) {
  Structure bare = molecule->structure;
  bare.bonds.clear();
  for (auto unused : state) {
    Structure structure = bare;
    perceive_bonds(structure);
    if (structure.bonds.size() < molecule->structure.bonds.size() / 2)
      state.SkipWithError("bonds are missing");
  }
  per_atom(state, molecule->structure.size());
}

}  // namespace

void add_molecule_benchmarks(const SharedMolecule& molecule) {
  benchmark::RegisterBenchmark(("read/" + molecule->name).c_str(), read, molecule);
  benchmark::RegisterBenchmark(("bonds/" + molecule->name).c_str(), perceive, molecule);
}

}  // namespace pliant::bench
