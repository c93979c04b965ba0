// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_recorder.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "pliant/record/h5md/h5md_reader.hpp"
#include "support/test.hpp"
#include "unit/record/samples.hpp"

namespace pliant::h5md_recorder_test {

using namespace test;
using testing::HasSubstr;

class H5mdRecorderTest : public FileTest {};

struct RoundTrip {
  const char* name;
  std::size_t joints;
  std::int64_t frames;
  H5mdOptions options;
};

class RoundTripTest : public FileTest, public testing::WithParamInterface<RoundTrip> {};

TEST_P(RoundTripTest, ReadsWhatWasRecorded) {
  const auto& [name, joints, frames, options] = GetParam();
  record_file(path_, joints, frames, options);
  const H5mdReader reader(path_);
  ASSERT_EQ(reader.frames(), frames);
  EXPECT_EQ(reader.bytes_per_coordinate(), 8u);
  const auto stop = reader.observable("stop");
  const auto force = reader.observable("force_x");
  const auto root = reader.observable("root_joint");
  for (std::int64_t f = 0; f < frames; ++f) {
    const SampleFrame sample = sample_frame(f, joints);
    const auto positions = reader.positions(f);
    for (std::size_t i = 0; i < joints; ++i) {
      const Vec3 expected = sample.positions[i];
      ASSERT_NEAR(positions[i].x, expected.x, 0.5 * options.precision);
      ASSERT_NEAR(positions[i].z, expected.z, 0.5 * options.precision);
    }
    const auto at = static_cast<std::size_t>(f);
    ASSERT_EQ(reader.step(f), sample.frame.step);
    ASSERT_EQ(reader.time(f), sample.frame.time);
    ASSERT_EQ(stop[at], double(sample.frame.stop));
    ASSERT_EQ(force[at], sample.frame.force.x);
    ASSERT_EQ(root[at], double(sample.frame.root_joint));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, RoundTripTest,
    ::testing::Values(RoundTrip{"one_joint", 1, 3, {}}, RoundTrip{"tiny", 4, 1000, {}},
                      RoundTrip{"tiny_committed_each", 4, 300, {.flush_seconds = 0.0}},
                      RoundTrip{"tiny_never_flushed", 4, 20'000, {.flush_seconds = 1e9}},
                      RoundTrip{"rounded", 50, 80, {.precision = 1e-3}},
                      RoundTrip{"rounded_each", 50, 80, {.precision = 1e-3, .flush_seconds = 0.0}},
                      RoundTrip{"large", 20'000, 5, {}}),
    [](const auto& trip) { return trip.param.name; });

TEST_F(H5mdRecorderTest, RecordsNamesBarsAndParameters) {
  const Framework framework = named_chain(6);
  record_file(path_, 6, 2);
  const H5mdReader reader(path_);
  EXPECT_EQ(reader.group(), "trajectory");
  EXPECT_EQ(reader.bars(), std::vector<Bar>(framework.bars().begin(), framework.bars().end()));
  EXPECT_EQ(reader.rest_lengths(),
            std::vector<double>(framework.rest_lengths().begin(), framework.rest_lengths().end()));
  EXPECT_EQ(reader.bonds(), sample_header().bonds);
  EXPECT_EQ(reader.bond_origin_names(), sample_header().bond_origin_names);
  EXPECT_EQ(reader.pinned(), std::vector<Joint>{0});
  const auto atoms = reader.atoms();
  ASSERT_NE(atoms, nullptr);
  EXPECT_EQ(atoms->names, framework.atoms()->names);
  EXPECT_EQ(atoms->elements, framework.atoms()->elements);
  EXPECT_EQ(atoms->residue_of, framework.atoms()->residue_of);
  EXPECT_EQ(atoms->residues, framework.atoms()->residues);
  EXPECT_EQ(atoms->serials, framework.atoms()->serials);
  const std::vector<NamedParameter> expected{{"input/file", std::string("caff\xc3\xa9ine.xyz")},
                                             {"run/replayed", true},
                                             {"run/seed", std::int64_t{-9'000'000'000}},
                                             {"run/tolerance", 1e-6}};
  EXPECT_EQ(reader.parameters(), expected);
}

TEST_F(H5mdRecorderTest, RecordsMassesOfPinnedJointsWhenTheyAreGiven) {
  H5mdHeader header;
  {
    H5mdRecorder recorder(directory_ / "a.h5md", named_chain(3), header);
    recorder.record(sample_frame(0, 3).frame);
  }
  EXPECT_EQ(H5mdReader(directory_ / "a.h5md").masses(), (std::vector<double>{1.0, 13.0, 14.0}));
  header.masses = {12.0, 13.0, 14.0};
  {
    H5mdRecorder recorder(directory_ / "b.h5md", named_chain(3), header);
    recorder.record(sample_frame(0, 3).frame);
  }
  EXPECT_EQ(H5mdReader(directory_ / "b.h5md").masses(), header.masses);
  header.masses = {12.0};
  EXPECT_ERROR(OptionError, "H5mdHeader::masses has 1 values for 3 joints",
               H5mdRecorder(directory_ / "c.h5md", named_chain(3), header));
  EXPECT_FALSE(std::filesystem::exists(directory_ / "c.h5md"));
}

TEST_F(H5mdRecorderTest, RecordsAFrameworkWithoutNamesOrBars) {
  const Framework framework = bare(2);
  {
    H5mdRecorder recorder(path_, framework);
    recorder.record(sample_frame(0, 2).frame);
  }
  const H5mdReader reader(path_);
  EXPECT_EQ(reader.atoms(), nullptr);
  EXPECT_TRUE(reader.bars().empty());
  EXPECT_EQ(reader.framework().joint_count(), 2u);
}

TEST_F(H5mdRecorderTest, EscapesTextThatIsNotUtf8) {
  H5mdHeader header;
  header.parameters = {{"input/file", std::string("latin\xe9")}};
  {
    H5mdRecorder recorder(path_, named_chain(2), header);
    recorder.record(sample_frame(0, 2).frame);
  }
  EXPECT_EQ(H5mdReader(path_).parameters()[0].second, Parameter(std::string("latin\\xe9")));
}

TEST_F(H5mdRecorderTest, WritesTheSameBytesForTheSameRun) {
  record_file(directory_ / "a.h5md", 6, 100);
  ::usleep(1'100'000);  // long enough for a time stamp to differ
  record_file(directory_ / "b.h5md", 6, 100);
  EXPECT_EQ(content_of(directory_ / "a.h5md"), content_of(directory_ / "b.h5md"));
}

TEST_F(H5mdRecorderTest, RefusesFramesThatMakeNoSense) {
  const std::string path = path_.string();
  H5mdRecorder recorder(path, named_chain(6));
  SampleFrame sample = sample_frame(3, 6);
  recorder.record(sample.frame);
  EXPECT_ERROR(InputError, path + ": frame of step 15 comes after that of step 15",
               recorder.record(sample.frame));
  sample.frame.step = 16;
  sample.positions[4].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_ERROR(InputError, path + ": frame of step 16: position of A:LYS-3B:CA is not finite",
               recorder.record(sample.frame));
  sample.frame.positions = sample.frame.positions.first(5);
  EXPECT_ERROR(InputError, path + ": frame of step 16 has 5 positions for 6 joints",
               recorder.record(sample.frame));
  recorder.record(sample_frame(4, 6).frame);
  EXPECT_EQ(recorder.frames(), 2);
  recorder.close();
  EXPECT_EQ(H5mdReader(path).frames(), 2);
}

TEST_F(H5mdRecorderTest, RefusesBadOptionsBeforeItTouchesTheFile) {
  const auto message = [&](const H5mdHeader& header, const H5mdOptions& options) {
    return error_text<OptionError>([&] { H5mdRecorder(path_, named_chain(2), header, options); });
  };
  EXPECT_EQ(message({}, {.flush_seconds = -1.0}),
            "H5mdOptions::flush_seconds = -1.000000: must be 0 or more");
  const auto with = [](const std::string& name, const Parameter& value) {
    H5mdHeader header;
    header.parameters = {{"a/b", true}, {name, value}};
    return header;
  };
  EXPECT_EQ(message(with("a/b", 1.0), {}), "parameter \"a/b\": is given twice");
  EXPECT_EQ(message(with("", 1.0), {}),
            "parameter \"\": must be a path below /parameters, such as run/seed");
  EXPECT_EQ(message(with("topology/x", 1.0), {}),
            "parameter \"topology/x\": the groups framework, limit, sterics, torsion_preferences, "
            "topology and "
            "checkpoint are the "
            "file's own");
  EXPECT_EQ(message(with("x", std::numeric_limits<double>::quiet_NaN()), {}),
            "parameter \"x\": is not a number");
  EXPECT_ERROR(InputError, "a framework without joints has no trajectory",
               H5mdRecorder(path_, bare(0)));
  EXPECT_TRUE(std::filesystem::is_empty(directory_.path()));
}

}  // namespace pliant::h5md_recorder_test
