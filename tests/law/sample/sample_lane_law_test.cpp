// SPDX-License-Identifier: MIT
// What a sampler asks for comes out of the lanes of every level with the bits of one frame alone.
#include <optional>

#include "law/sample/sample_cases.hpp"
#include "pliant/conformers/torsions/conformer_framework.hpp"
#include "pliant/resolve/bodies/pull/froda_lanes.hpp"
#include "pliant/resolve/bodies/pull/froda_solver.hpp"
#include "pliant/sample/network/coarse_nodes.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace sample_lane_law_test {

constexpr std::int64_t count = 9;  // one more than lanes

class SampleLaneLaw : public test::SampleLaw {};
PLIANT_FOR_ALL_SAMPLERS(SampleLaneLaw);

FrodaOptions careful() {
  FrodaOptions options;
  options.has_torsion_preferences = true;
  options.is_careful = true;
  return options;
}

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

}  // namespace sample_lane_law_test
}  // namespace pliant
