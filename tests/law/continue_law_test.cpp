// SPDX-License-Identifier: MIT
// A run that goes on from its H5MD file records what one run without an end between records:
// positions and observables bit by bit, whatever the technique and the perturbation, also where
// steps do not converge.
#include <cstdlib>

#include "law/technique_cases.hpp"
#include "unit/record/recorded_runs.hpp"
#include "unit/record/samples.hpp"

namespace pliant {
namespace continue_law_test {

using test::go_on;
using test::record_run;
using test::TempDirectory;

class ContinueLaw : public test::TechniqueLaw {
 protected:
  static RunOptions options_of(const Framework& framework, const std::string& perturb) {
    RunOptions options;
    options.technique = plain();
    options.resolve.max_sweeps = 25;
    options.resolve.seed = 11;
    options.resolve.walker = 3;
    options.perturb_options.displacement = 0.5 * test::small_break(framework);
    options.perturb_options.timestep = 0.02;
    options.every = 2;
    const auto last = static_cast<Joint>(framework.joint_count() - 1);
    if (perturb == "replay")
      options.replay = {{0, {20, 0, 0}}, {last, {0, 9, 0}}, {last, {0, 5, 5}}, {0, {1, 1, 1}},
                        {0, {0, 7, 0}},  {last, {3, 0, 3}}, {last, {0, 0, 4}}, {0, {2, 0, 0}}};
    else if (perturb == "guide")
      options.guide = test::guide_of(framework);
    else
      options.perturb = perturb;
    return options;
  }
};

/// In three parts: the end of the first is a frame that the whole run does not record, the end of
/// the second is one that it does. Some examples take a perturbation each; the law of
/// restarts takes all.
TEST_P(ContinueLaw, ThreePartsAreTheWhole) {
  const std::vector<std::string> perturbations{"force", "force_all", "displacement", "replay",
                                               "guide"};
  const TempDirectory directory;
  std::size_t count = 0;
  each_example([&](const Example& example) {
    if (example.framework.joint_count() == 0) return;
    if (count++ % 11 != 0 && std::getenv("PLIANT_ALL") == nullptr) return;
    const std::string& perturb = perturbations[count % perturbations.size()];
    SCOPED_TRACE(perturb);
    RunOptions options = options_of(example.framework, perturb);
    const H5mdOptions recording{.single = perturb == "force_all"};
    const auto whole = directory / ("whole-" + std::to_string(count));
    const auto parts = directory / ("parts-" + std::to_string(count));
    const State start(example.positions);
    options.steps = 8;
    record_run(whole, example.framework, start, options, recording);
    options.steps = 3;
    record_run(parts, example.framework, start, options, recording);
    go_on(parts, 6);
    go_on(parts, 8);
    test::expect_same_file(whole, parts);
  });
}

PLIANT_FOR_ALL_TECHNIQUES(ContinueLaw);

}  // namespace continue_law_test
}  // namespace pliant
