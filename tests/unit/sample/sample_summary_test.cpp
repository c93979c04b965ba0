// SPDX-License-Identifier: MIT
#include "pliant/sample/sample_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pliant {
namespace sample_summary_test {

const std::vector<Vec3> start{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}};

/// The last joint goes up and down; the others, by which frames are superposed, stay.
std::vector<Vec3> frame(double up, Vec3 shift = {}) {
  std::vector<Vec3> x = start;
  x[3].z += up;
  for (Vec3& at : x) at += shift;
  return x;
}

TEST(FluctuationSums, AreAboutTheMeanWithoutShifts) {
  FluctuationSums sums(start, {0, 1, 2});
  sums.add(frame(1.0), false);
  sums.add(frame(3.0, {5, -2, 1}), true);
  const std::vector<double> rmsf = sums.rmsf();
  EXPECT_NEAR(rmsf[3], 1.0, 1e-9);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(rmsf[k], 0.0, 1e-6);
}

TEST(FluctuationSums, TheErrorIsHalfTheDifferenceOfHalves) {
  FluctuationSums sums(start, {0, 1, 2});
  for (double up : {-1.0, 1.0}) sums.add(frame(up), false);
  EXPECT_EQ(sums.error()[3], 0.0);  // the second half has no frame
  for (double up : {-2.0, 2.0}) sums.add(frame(up), true);
  EXPECT_NEAR(sums.error()[3], 0.5, 1e-9);
}

TEST(SampleSummary, WarnsOfLessThanHalfOfTheAmplitude) {
  std::string said;
  Log log;
  log.function = [&](Severity, std::string_view text) { said = text; };
  SampleSummary summary;
  summary.frames = 10;
  summary.near_frames = summary.frames;
  summary.amplitude_asked = 1.4;
  summary.amplitude_reached = 0.71;
  warn_of_amplitude(summary, log);
  EXPECT_EQ(said, "");
  summary.amplitude_reached = 0.5;
  warn_of_amplitude(summary, log);
  EXPECT_EQ(said,
            "frames reach an amplitude of 0.50 of the 1.40 Angstrom asked for: the molecule is "
            "held too tightly to move that far");
}

}  // namespace sample_summary_test
}  // namespace pliant
