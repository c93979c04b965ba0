// SPDX-License-Identifier: MIT
// One number that every build must agree on: Debug and Release, gcc and clang, with and without
// sanitizers. The library is compiled with -ffp-contract=off, draws its own random numbers and
// calls no function of libm whose last bits differ (square roots are exact).
#include <gtest/gtest.h>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/perturb/perturbation.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/run/run.hpp"
#include "support/frameworks.hpp"

namespace pliant::determinism_test {

/// The positions of all frames of a run of 200 steps, step by step.
std::uint64_t hash_of_run(const Sketch& sketch, std::string_view perturbation,
                          const Technique& technique, std::uint64_t hash) {
  const Framework framework = test::with_masses(framework_of(sketch));
  State state(sketch.positions);
  const RunSummary summary = run(framework, state,
                                 {.technique = technique,
                                  .resolve = {.max_sweeps = 40, .seed = 20240229},
                                  .perturb = std::string(perturbation),
                                  .perturb_options = {.timestep = 0.02},
                                  .steps = 200},
                                 {[&](const Frame& frame) {
                                   hash = test::hash_of(frame.positions, hash);
                                   return false;
                                 }});
  EXPECT_EQ(summary.frames, 201);
  return hash;
}

/// Three frameworks whose places come from exact arithmetic: a chain, a grid, a random cluster.
std::uint64_t hash_of_runs(std::string_view perturbation, const Technique& technique) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const Sketch& sketch : {chain(12), grid(3, 3), with_angles(shaken(chain(8), 0.25))})
    hash = hash_of_run(sketch, perturbation, technique, hash);
  return hash;
}

// The numbers of the first build; a change of them changes what every user's run gives, and
// goes into the changelog.
TEST(Determinism, EveryPerturbationGivesTheseBits) {
  const std::pair<std::string_view, std::uint64_t> expected[] = {
      {"force", 0x19239afaf5993254},
      {"force_all", 0x11f73aa027c20924},
      {"displacement", 0x53359ffe463d8bfc},
  };
  for (const PerturbationEntry& entry : perturbations()) {
    SCOPED_TRACE(entry.name);
    const auto* row = std::find_if(std::begin(expected), std::end(expected),
                                   [&](const auto& e) { return e.first == entry.name; });
    ASSERT_NE(row, std::end(expected)) << "add the hash of the new perturbation";
    EXPECT_EQ(hash_of_runs(entry.name, {"bfs_cycle", 0.5, true}), row->second);
  }
}

TEST(Determinism, EveryTechniqueGivesTheseBits) {
  const std::pair<std::string_view, std::uint64_t> expected[] = {
      {"random", 0x62c2fdce3be2ad0d},      {"bfs_cycle", 0xb49b02afb763cfc3},
      {"dfs_cycle", 0x65622ee77e18652a},   {"bfs_reverse", 0x9c529f8f60995994},
      {"dfs_reverse", 0xbd12460d79bd7aab}, {"bfs_adapt", 0xa1c0635f3c527017},
      {"bfs_random", 0x9e8dff8541149e33},  {"input", 0x62c06a3a9c51b7c6},
      {"blocks", 0x8db9d18067dabc7d},      {"anderson", 0x0e9e22f625d32b5d},
      {"newton", 0x414f202addf94c8d},      {"shake", 0xad73d9d3fd38946e},
      {"units", 9225199486431949951u},     {"auto", 9225199486431949951u},
      {"froda", 8196874109771948787u},
  };
  for (const TechniqueEntry& entry : techniques()) {
    if (entry.forests_only) continue;
    SCOPED_TRACE(entry.name);
    const auto* row = std::find_if(std::begin(expected), std::end(expected),
                                   [&](const auto& e) { return e.first == entry.name; });
    ASSERT_NE(row, std::end(expected)) << "add the hash of the new technique";
    EXPECT_EQ(hash_of_runs("displacement", {std::string(entry.name), 0.75}), row->second);
  }
}

/// Techniques that look only where a push of one joint reaches.
TEST(Determinism, LocalTechniquesGiveTheseBits) {
  EXPECT_EQ(hash_of_runs("force", {"blocks"}), 12935495421400711860u);
}

}  // namespace pliant::determinism_test
