// SPDX-License-Identifier: MIT
#include "pliant/sample/sample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "pliant/base/error.hpp"
#include "pliant/sample/amplitudes.hpp"
#include "pliant/sample/sample_summary.hpp"
#include "pliant/sample/samplers.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"
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
  FrameworkParts parts = one.framework.parts();
  std::vector<Vec3> start = one.positions;
  const auto joints = static_cast<Joint>(parts.joint_count);
  const std::size_t bars = parts.bars.size();
  for (std::size_t k = 0; k < bars; ++k) {
    parts.bars.push_back({parts.bars[k].a + joints, parts.bars[k].b + joints});
    parts.rest_lengths.push_back(parts.rest_lengths[k]);
  }
  for (Joint k = 0; k < joints; ++k) start.push_back(start[k] + Vec3{0, 0, 9});
  parts.joint_count *= 2;
  parts.masses.clear();
  parts.sterics = nullptr;
  parts.torsion_preferences = nullptr;
  parts.atoms = nullptr;
  parts.drawn = start;
  EXPECT_EQ(usual_sampler(Framework(std::move(parts)), start, 0), "modes");
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
