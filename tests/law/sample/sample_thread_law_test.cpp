// SPDX-License-Identifier: MIT
// Any number of threads gives the same bits.
#include "law/sample/sample_cases.hpp"

namespace pliant {
namespace sample_thread_law_test {

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

}  // namespace sample_thread_law_test
}  // namespace pliant
