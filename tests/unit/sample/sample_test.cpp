// SPDX-License-Identifier: MIT
#include "pliant/sample/sample.hpp"

#include "pliant/sample/amplitudes.hpp"
#include "pliant/sample/sample_summary.hpp"
#include "pliant/sample/samplers.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant::sample_test {

using test::Peptide;
using test::peptide;

std::vector<std::vector<Vec3>> frames_of(const Peptide& p, const SampleOptions& options) {
  std::vector<std::vector<Vec3>> frames;
  sample(p.framework, p.start, p.nodes, options, [&](const Frame& frame) {
    frames.emplace_back(frame.positions.begin(), frame.positions.end());
    return false;
  });
  return frames;
}

/// Of all samplers and pieces: tests/law/sample; this is for the thread sanitizer.
TEST(Sample, FramesAreTheSameOnThreads) {
  const Peptide p = peptide();
  SampleOptions options{.frames = 12, .amplitude = 0.5, .seed = 9};
  const auto alone = frames_of(p, options);
  options.threads = 3;
  const auto threaded = frames_of(p, options);
  ASSERT_EQ(alone.size(), 12u);
  for (std::size_t k = 0; k < 12; ++k) EXPECT_TRUE(test::same_bits(alone[k], threaded[k])) << k;
}

TEST(Sample, StopsWhereTheObserverAsks) {
  const Peptide p = peptide();
  const SampleSummary summary =
      sample(p.framework, p.start, p.nodes, {.frames = 50, .amplitude = 0.2},
             [](const Frame& frame) { return frame.step == 2; });
  EXPECT_TRUE(summary.stopped_by_caller);
  EXPECT_EQ(summary.frames, 3);
  EXPECT_GT(summary.amplitude_reached, 0.02);
}

TEST(Sample, RefusesAStartThatIsNotWhole) {
  Peptide p = peptide();
  p.start[0].x += 0.1;
  EXPECT_THAT(test::error_text<Error>([&] { sample(p.framework, p.start, p.nodes, {}, {}); }),
              testing::MatchesRegex("the start: bar .* is not whole; resolve it first"));
}

TEST(Samplers, EachHasANameOfItsOwnAndSaysWhatItDoes) {
  std::set<std::string_view> names;
  for (const SamplerEntry& row : samplers()) {
    EXPECT_TRUE(names.insert(row.name).second);
    EXPECT_FALSE(row.summary.empty());
    EXPECT_EQ(&find_sampler(row.name), &row);
  }
  EXPECT_EQ(test::error_text<OptionError>([] {
              find_sampler("mode");
            }).rfind("no sampler named \"mode\" (did you mean \"modes\"?)", 0),
            0U);
}

TEST(Samplers, TheUsualOneFollowsFromTheMolecule) {
  const auto usual = [](const char* file, std::size_t residues, bool has_place = false) {
    const MolecularModel model = test::model_of(file);
    return usual_sampler(model.framework, model.positions, residues, has_place);
  };
  EXPECT_EQ(usual("butane.sdf", 0), "torsions");
  EXPECT_EQ(usual("butane.sdf", 100), "modes");
  EXPECT_EQ(usual("butane.sdf", 101), "reach");
  EXPECT_EQ(usual("butane.sdf", 0, true), "pocket");
  EXPECT_EQ(usual("crown_18_6.cif", 0), "torsions");
}

TEST(Samplers, SeveralMoleculesMoveAgainstEachOtherByModes) {
  const MolecularModel one = test::model_of("butane.sdf");
  const Framework two = test::copies_of(one.framework, one.positions, 2, {0, 0, 9});
  EXPECT_EQ(usual_sampler(two, two.drawn(), 0), "modes");
}

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
  const Log log{[&](Severity, std::string_view text) { said = text; }};
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

/// Mean 0 and covariance 1, which independent draws would miss by a tenth.
TEST(Amplitudes, ABlockIsWhite) {
  for (std::size_t modes : {std::size_t{1}, std::size_t{60}, std::size_t{99}}) {
    const DenseMatrix a = white_amplitudes(3, 5, modes);
    ASSERT_EQ(a.rows(), 100u);
    for (std::size_t m = 0; m < modes; ++m) {
      double mean = 0.0;
      for (std::size_t f = 0; f < 100; ++f) mean += a(f, m) / 100.0;
      EXPECT_NEAR(mean, 0.0, 1e-13);
      for (std::size_t k = 0; k <= m; ++k) {
        double product = 0.0;
        for (std::size_t f = 0; f < 100; ++f) product += a(f, m) * a(f, k) / 100.0;
        EXPECT_NEAR(product, m == k, 1e-12) << m << " " << k;
      }
    }
  }
}

TEST(Amplitudes, DependOnSeedAndBlockAlone) {
  const DenseMatrix one = white_amplitudes(3, 5, 20);
  const auto differs = [&](const DenseMatrix& other) {
    return !std::equal(one.row(7).begin(), one.row(7).end(), other.row(7).begin());
  };
  EXPECT_FALSE(differs(white_amplitudes(3, 5, 20)));
  EXPECT_TRUE(differs(white_amplitudes(3, 6, 20)));
  EXPECT_TRUE(differs(white_amplitudes(4, 5, 20)));
  EXPECT_FALSE(differs(white_amplitudes(3, 5, 30))) << "more modes do not change the first";
  EXPECT_NE(redrawn_amplitudes(3, 5, 1, 20), redrawn_amplitudes(3, 5, 2, 20));
}

}  // namespace pliant::sample_test
