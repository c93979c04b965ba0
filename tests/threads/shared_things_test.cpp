// SPDX-License-Identifier: MIT
// What is const may be used by several threads at once, and what is each thread's own has nothing
// to do with that of others. The thread sanitizer sees whether this is so.
#include <thread>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/run/run.hpp"
#include "support/frameworks.hpp"
#include "support/source_folder.hpp"
#include "support/test.hpp"

namespace pliant::shared_things_test {

constexpr int thread_count = 4;

/// Calls work(number) on as many threads at once.
template <class Work>
void on_threads(const Work& work) {
  std::vector<std::jthread> threads;
  for (int number = 0; number < thread_count; ++number)
    threads.emplace_back([&work, number] { work(number); });
}

std::string molecule(const char* name) { return molecule_file(name); }

TEST(SharedThings, FilesAreReadByAll) {
  for (const char* name : {"alanine_dipeptide.pdb", "cholesterol.cif", "caffeine.sdf", "c60.xyz"}) {
    std::vector<std::size_t> bars(thread_count);
    on_threads([&](int number) {
      Structure structure = read_structure(molecule(name));
      perceive_bonds(structure, {});
      bars[static_cast<std::size_t>(number)] =
          build_framework(structure, {.bars = BarKind::angles}).bar_count();
    });
    EXPECT_EQ(bars, std::vector<std::size_t>(thread_count, bars[0])) << name;
    EXPECT_GT(bars[0], 0U);
  }
}

TEST(SharedThings, OneFrameworkServesAllTechniques) {
  const Framework framework = framework_of(with_angles(shaken(chain(12), 0.2)));
  const std::vector<Vec3> start = shaken(chain(12), 0.2).positions;
  for (const TechniqueEntry& entry : techniques()) {
    if (entry.forests_only) continue;
    std::vector<std::vector<Vec3>> ends(thread_count);
    on_threads([&](int number) {
      const RunOptions options{
          .technique = {.name = entry.name == "input" ? "auto" : std::string(entry.name)},
          .resolve = {.max_sweeps = 50},
          .steps = 3};
      State state{start};
      run(framework, state, options, {});
      ends[static_cast<std::size_t>(number)] = state.positions;
    });
    for (const std::vector<Vec3>& end : ends)
      EXPECT_TRUE(test::same_bits(end, ends[0])) << entry.name;
  }
}

TEST(SharedThings, EachThreadRecordsAndReadsAFile) {
  const test::TempDirectory folder;
  const Sketch sketch = ring(6);
  const Framework framework = framework_of(sketch);
  std::vector<std::int64_t> frames(thread_count);
  on_threads([&](int number) {
    const auto path = folder / (std::to_string(number) + ".h5md");
    H5mdRecorder recorder(path, framework, {}, {});
    RunOptions options{.steps = 50};
    State state{sketch.positions};
    run(framework, state, options, {[&](const Frame& frame) {
          recorder.record(frame);
          return false;
        }});
    recorder.close();
    H5mdReader reader(path);
    for (std::int64_t frame = 0; frame < reader.frames(); ++frame)
      frames[static_cast<std::size_t>(number)] += reader.positions(frame).size() == 6 ? 1 : 0;
  });
  EXPECT_EQ(frames, std::vector<std::int64_t>(thread_count, 51));
}

}  // namespace pliant::shared_things_test
