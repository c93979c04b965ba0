// SPDX-License-Identifier: MIT
// Frames made in pieces are those of the whole, across blocks of frames too.
#include "law/sample/sample_cases.hpp"

namespace pliant {
namespace sample_piece_law_test {

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

}  // namespace sample_piece_law_test
}  // namespace pliant
