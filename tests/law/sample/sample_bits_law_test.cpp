// SPDX-License-Identifier: MIT
// Frames are a function of the seed: one seed gives the same bits, on any number of threads, in
// pieces, and in lanes of every level; another gives other frames, unless a warning says that all
// are the same.
#include "law/sample/sample_cases.hpp"
#include "pliant/conformers/torsions/conformer_framework.hpp"
#include "pliant/resolve/bodies/pull/froda_lanes.hpp"
#include "pliant/resolve/bodies/pull/froda_solver.hpp"
#include "pliant/sample/network/coarse_nodes.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::sample_bits_law_test {

class SampleSeedLaw : public test::SampleLaw {};
PLIANT_FOR_ALL_SAMPLERS(SampleSeedLaw);

TEST_P(SampleSeedLaw, TheSameGivesTheSameBits) {
  each_case([](const test::SampleCase& at) {
    const SampleOptions options = test::options_of(at);
    test::expect_same_frames(test::frames_of(at, options), test::frames_of(at, options));
  });
}

TEST_P(SampleSeedLaw, AnotherGivesOtherFrames) {
  each_case([](const test::SampleCase& at) {
    SampleOptions options = test::options_of(at);
    bool are_alike = false;
    options.log.function = [&](Severity, std::string_view text) {
      are_alike = are_alike || text.ends_with("all conformers are the same");
    };
    std::vector<test::KeptFrame> all = test::frames_of(at, options);
    ++options.seed;
    for (test::KeptFrame& frame : test::frames_of(at, options)) all.push_back(std::move(frame));
    std::size_t alike = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        alike += test::same_bits(all[i].positions, all[j].positions) ? 1U : 0U;
    const std::size_t pairs = all.size() * (all.size() - 1) / 2;
    if (are_alike) {
      EXPECT_EQ(alike, pairs);
    } else {  // cyclohexane alone has a few forms, each of the same bits
      EXPECT_LT(alike, sampler().has_amplitude ? 1 : pairs);
    }
  });
}

class SampleThreadLaw : public test::SampleLaw {};
PLIANT_FOR_ALL_SAMPLERS(SampleThreadLaw);

TEST_P(SampleThreadLaw, AnyNumberGivesTheSameBits) {
  each_case([](const test::SampleCase& at) {
    SampleOptions options = test::options_of(at);
    options.frames = 8;
    const auto alone = test::frames_of(at, options);
    for (const std::int64_t threads : {2, 5}) {
      SCOPED_TRACE(std::to_string(threads) + " threads");
      options.threads = threads;
      test::expect_same_frames(alone, test::frames_of(at, options));
    }
  });
}

class SamplePieceLaw : public test::SampleLaw {};
PLIANT_FOR_ALL_SAMPLERS(SamplePieceLaw);

TEST_P(SamplePieceLaw, FramesAreThoseOfTheWhole) {
  each_case([](const test::SampleCase& at) {
    SampleOptions options = test::options_of(at);
    if (!sampler().near_sampler.empty()) options.near_frames = 99;
    const std::int64_t first = 97;
    const auto piece = [&](std::int64_t begin, std::int64_t frames) {
      options.first_frame = first + begin;
      options.frames = frames;
      return test::frames_of(at, options);
    };
    auto pieces = piece(0, 1);
    for (const auto& [begin, frames] : {std::pair(1, 3), std::pair(4, 1)})
      for (test::KeptFrame& frame : piece(begin, frames)) pieces.push_back(std::move(frame));
    test::expect_same_frames(pieces, piece(0, 5));
  });
}

constexpr std::int64_t count = 9;  // one more than lanes

class SampleLaneLaw : public test::SampleLaw {};
PLIANT_FOR_ALL_SAMPLERS(SampleLaneLaw);

FrodaOptions careful() { return {.is_careful = true, .has_torsion_preferences = true}; }

/// The first steps of some frames.
struct Asked {
  std::vector<FrameRequest> requests{count};
  std::vector<std::vector<Vec3>> out{count};
  std::vector<FrodaJob> jobs;

  Asked(const Sampler& sampler, std::span<const Vec3> start) {
    for (std::size_t k = 0; k < requests.size(); ++k) {
      FrameRequest& at = requests[k];
      sampler.ask(static_cast<std::int64_t>(k), 0, 0, start, at);
      out[k].resize(start.size());
      jobs.push_back({{at.from.empty() ? start : std::span<const Vec3>(at.from), at.targets,
                       at.limits_off, at.course.at ? &at.course : nullptr},
                      out[k]});
    }
  }
};

void expect_lanes_as_alone(const SampleTask& task, const BodyPlan& plan) {
  const NetworkNodes nodes = coarsened(task.nodes());
  SampleOptions options = task.options();
  options.frames = count;
  const auto sampler =
      find_sampler(options.sampler).make({task.framework(), plan, task.start(), nodes, options});
  Asked alone(*sampler, task.start());
  FrodaSolver solver(task.framework(), plan);
  for (FrodaJob& job : alone.jobs) job.result = solver.resolve(job.push, job.out, careful());
  for (const LaneKernels* level : lane_levels()) {
    SCOPED_TRACE(level->level);
    Asked together(*sampler, task.start());
    FrodaLanes(task.framework(), plan, *level).resolve(together.jobs, careful());
    for (std::size_t k = 0; k < alone.jobs.size(); ++k) {
      EXPECT_TRUE(test::same_bits(together.out[k], alone.out[k])) << k;
      EXPECT_EQ(together.jobs[k].result.is_whole, alone.jobs[k].result.is_whole) << k;
      EXPECT_EQ(together.jobs[k].result.steps, alone.jobs[k].result.steps) << k;
    }
  }
}

TEST_P(SampleLaneLaw, EveryLevelGivesTheBitsOfOneFrameAlone) {
  std::size_t in_lanes = 0;
  each_case([&](const test::SampleCase& at) {
    const auto task = test::task_of(at, test::options_of(at));
    const std::optional<BodyPlan> plan = sampler().has_amplitude
                                             ? BodyPlan::make(task->framework())
                                             : conformer_plan(task->framework(), task->start());
    ASSERT_TRUE(plan);
    if (!FrodaLanes::can_take(*plan)) return;
    ++in_lanes;
    expect_lanes_as_alone(*task, *plan);
  });
  EXPECT_GT(in_lanes, 0U);
}

}  // namespace pliant::sample_bits_law_test
