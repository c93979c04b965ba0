// SPDX-License-Identifier: MIT
// pliant_bench [--benchmark_filter=REGEX ...] [FILE...]: times on the given molecule files, or on
// all of data/molecules.
#include "bench/bench.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/read/read.hpp"
#include "support/source_folder.hpp"

namespace {

namespace fs = std::filesystem;
using pliant::bench::Molecule;
using pliant::bench::SharedMolecule;

std::vector<fs::path> files_to_time(int count, char** arguments) {
  if (count > 1) return {arguments + 1, arguments + count};
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(pliant::molecules_folder()))
    found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

SharedMolecule load(const fs::path& file, pliant::BarKind bars) {
  pliant::Structure structure = pliant::read_structure(file);
  perceive_bonds(structure);
  pliant::Framework framework = build_framework(structure, {.bars = bars});
  return std::make_shared<Molecule>(
      Molecule{file.stem().string(), file.string(), std::move(structure), std::move(framework)});
}

}  // namespace

int main(int count, char** arguments) try {
  benchmark::Initialize(&count, arguments);
  for (const fs::path& file : files_to_time(count, arguments)) {
    const SharedMolecule molecule = load(file, pliant::BarKind::bonds);
    pliant::bench::add_molecule_benchmarks(molecule);
    pliant::bench::add_resolve_benchmarks(molecule);
    pliant::bench::add_lane_benchmarks(molecule);
    pliant::bench::add_froda_benchmarks(molecule);
    pliant::bench::add_angle_benchmarks(load(file, pliant::BarKind::angles));
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
} catch (const pliant::Error& error) {
  std::fprintf(stderr, "pliant_bench: %s\n", error.what());
  return 1;
}
