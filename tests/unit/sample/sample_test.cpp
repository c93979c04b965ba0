// SPDX-License-Identifier: MIT
#include "pliant/sample/sample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "pliant/base/error.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"

namespace pliant {
namespace sample_test {

using test::peptide;
using test::Peptide;

std::vector<std::vector<Vec3>> frames_of(const Peptide& p, const SampleOptions& options) {
  std::vector<std::vector<Vec3>> frames;
  sample(p.framework, p.start, p.nodes, options, [&](const Frame& frame) {
    frames.emplace_back(frame.positions.begin(), frame.positions.end());
    return false;
  });
  return frames;
}

/// A ring of rings: bars are whole although loops were cut.
TEST(Sample, EveryBarIsWholeAndAtomsMove) {
  const Peptide p = peptide();
  for (const char* sampler : {"modes", "dilute"}) {
    SampleOptions options;
    options.frames = 10;
    options.amplitude = 0.5;
    options.sampler = sampler;
    const SampleSummary summary = sample(p.framework, p.start, p.nodes, options, {});
    EXPECT_EQ(summary.frames, 10) << sampler;
    EXPECT_EQ(summary.failed, 0) << sampler;
    EXPECT_LT(summary.max_residual, 1e-10) << sampler;
    EXPECT_GT(summary.amplitude_reached, 0.05) << sampler;
  }
}

TEST(Sample, FramesAreTheSameInPiecesAndOnThreads) {
  const Peptide p = peptide();
  SampleOptions options;
  options.frames = 12;
  options.amplitude = 0.5;
  options.seed = 9;
  const auto whole = frames_of(p, options);
  options.threads = 3;
  const auto threaded = frames_of(p, options);
  options.frames = 5;
  options.first_frame = 7;
  const auto piece = frames_of(p, options);
  ASSERT_EQ(whole.size(), 12u);
  for (std::size_t k = 0; k < 12; ++k) EXPECT_TRUE(test::same_bits(whole[k], threaded[k])) << k;
  for (std::size_t k = 0; k < 5; ++k) EXPECT_TRUE(test::same_bits(whole[k + 7], piece[k])) << k;
  options.seed = 10;
  EXPECT_FALSE(test::same_bits(frames_of(p, options)[0], piece[0]));
}

TEST(Sample, StopsWhereTheObserverAsks) {
  const Peptide p = peptide();
  SampleOptions options;
  options.frames = 50;
  options.amplitude = 0.2;
  const SampleSummary summary = sample(p.framework, p.start, p.nodes, options,
                                       [](const Frame& frame) { return frame.step == 2; });
  EXPECT_TRUE(summary.stopped_by_caller);
  EXPECT_EQ(summary.frames, 3);
}

TEST(Sample, RefusesWhatItCannotSample) {
  const Peptide p = peptide();
  const auto text = [&](const Framework& framework, const std::vector<Vec3>& start,
                        const NetworkNodes& nodes, const SampleOptions& options) {
    return test::error_text<Error>([&] { sample(framework, start, nodes, options, {}); });
  };
  SampleOptions options;
  options.network = "amn";
  EXPECT_EQ(text(p.framework, p.start, p.nodes, options),
            "no network named \"amn\"; known: shared, anm, pfanm, gnm");
  options = {};
  options.amplitude = 0.0;
  EXPECT_EQ(text(p.framework, p.start, p.nodes, options),
            "amplitude = 0: must be positive and finite");
  EXPECT_EQ(text(test::with_pinned(p.framework, {0}), p.start, p.nodes, {}),
            "sample: the framework has pinned joints, or lies in a plane");
  std::vector<Vec3> moved = p.start;
  moved[0].x += 0.1;
  EXPECT_THAT(text(p.framework, moved, p.nodes, {}),
              testing::MatchesRegex("the start: bar .* is not whole; resolve it first"));
  NetworkNodes one = p.nodes;
  one.positions.resize(1);
  EXPECT_EQ(text(p.framework, p.start, one, {}), "network: 1 node; it needs 2 or more");
}

}  // namespace sample_test
}  // namespace pliant
