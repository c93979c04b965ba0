// SPDX-License-Identifier: MIT
// Frames are a function of the seed: one seed gives the same bits, another other frames, unless a
// warning says that all are the same.
#include "law/sample/sample_cases.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace sample_seed_law_test {

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

/// Samplers without amplitude follow no modes.
TEST_P(SampleSeedLaw, ANetworkMattersWhereFramesFollowItsModes) {
  std::size_t same = 0, cases = 0;
  each_case([&](const test::SampleCase& at) {
    SampleOptions options = test::options_of(at);
    options.frames = 1;
    const auto usual = test::frames_of(at, options);
    options.network = std::string(networks()[(at.network + 1) % networks().size()].name);
    const auto other = test::frames_of(at, options);
    ASSERT_EQ(usual.size(), other.size());
    same += test::same_bits(usual[0].positions, other[0].positions) ? 1U : 0U;
    ++cases;
  });
  if (sampler().has_amplitude) {
    EXPECT_LT(same, cases);
  } else {
    EXPECT_EQ(same, cases);
  }
}

}  // namespace sample_seed_law_test
}  // namespace pliant
