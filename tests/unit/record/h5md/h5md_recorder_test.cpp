// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <limits>
#include <thread>

#include "pliant/base/error.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "unit/record/samples.hpp"

namespace pliant {
namespace h5md_recorder_test {

using namespace test;
using ::testing::HasSubstr;

H5mdHeader sample_header() {
  H5mdHeader header;
  header.bonds = {{0, 1, 0, 1}, {1, 2, 3, 2}, {0, 3, 1, 4}};
  header.bond_origin_names = {"file", "residue", "link", "distance"};
  header.parameters = {{"run/seed", std::int64_t{-9'000'000'000}},
                       {"run/tolerance", 1e-6},
                       {"input/file", std::string("caff\xc3\xa9ine.xyz")},
                       {"run/replayed", true}};
  return header;
}

void record_frames(H5mdRecorder& recorder, std::size_t joints, std::int64_t frames) {
  for (std::int64_t f = 0; f < frames; ++f) recorder.record(sample_frame(f, joints).frame);
}

void record_file(const std::filesystem::path& path, std::size_t joints, std::int64_t frames,
                 const H5mdOptions& options = {}) {
  H5mdRecorder recorder(path, chain(joints), sample_header(), options);
  record_frames(recorder, joints, frames);
  recorder.close();
}

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct RoundTrip {
  const char* name;
  std::size_t joints;
  std::int64_t frames;
  H5mdOptions options;
};

class RoundTripTest : public ::testing::TestWithParam<RoundTrip> {};

TEST_P(RoundTripTest, ReadsWhatWasRecorded) {
  const auto& [name, joints, frames, options] = GetParam();
  const TempDirectory directory;
  record_file(directory / "run.h5md", joints, frames, options);
  const H5mdReader reader(directory / "run.h5md");
  ASSERT_EQ(reader.frames(), frames);
  EXPECT_EQ(reader.bytes_per_coordinate(), options.single ? 4u : 8u);
  const auto stop = reader.observable("stop");
  const auto force = reader.observable("force_x");
  const auto root = reader.observable("root_joint");
  for (std::int64_t f = 0; f < frames; ++f) {
    const SampleFrame sample = sample_frame(f, joints);
    const auto positions = reader.positions(f);
    for (std::size_t i = 0; i < joints; ++i) {
      const Vec3 expected = sample.positions[i];
      ASSERT_EQ(positions[i].x, options.single ? double(float(expected.x)) : expected.x);
      ASSERT_EQ(positions[i].z, options.single ? double(float(expected.z)) : expected.z);
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
    ::testing::Values(RoundTrip{"no_frames", 4, 0, {}}, RoundTrip{"one_joint", 1, 3, {}},
                      RoundTrip{"tiny", 4, 1000, {}},
                      RoundTrip{"tiny_committed_each", 4, 300, {.flush_seconds = 0.0}},
                      RoundTrip{"tiny_never_flushed", 4, 20'000, {.flush_seconds = 1e9}},
                      RoundTrip{"single", 7, 300, {.single = true}},
                      RoundTrip{"compressed", 50, 80, {.compress = true}},
                      RoundTrip{"compressed_single_each",
                                50,
                                80,
                                {.single = true, .compress = true, .flush_seconds = 0.0}},
                      RoundTrip{"large", 20'000, 5, {}}),
    [](const auto& trip) { return trip.param.name; });

TEST(H5mdRecorder, RecordsNamesBarsAndParameters) {
  const TempDirectory directory;
  const Framework framework = chain(6);
  record_file(directory / "run.h5md", 6, 2);
  const H5mdReader reader(directory / "run.h5md");
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

TEST(H5mdRecorder, RecordsMassesOfPinnedJointsWhenTheyAreGiven) {
  const TempDirectory directory;
  H5mdHeader header;
  {
    H5mdRecorder recorder(directory / "a.h5md", chain(3), header);
    recorder.record(sample_frame(0, 3).frame);
  }
  EXPECT_EQ(H5mdReader(directory / "a.h5md").masses(), (std::vector<double>{1.0, 13.0, 14.0}));
  header.masses = {12.0, 13.0, 14.0};
  {
    H5mdRecorder recorder(directory / "b.h5md", chain(3), header);
    recorder.record(sample_frame(0, 3).frame);
  }
  EXPECT_EQ(H5mdReader(directory / "b.h5md").masses(), header.masses);
  header.masses = {12.0};
  EXPECT_EQ(message_of<OptionError>([&] { H5mdRecorder(directory / "c.h5md", chain(3), header); }),
            "H5mdHeader::masses has 1 values for 3 joints");
  EXPECT_FALSE(std::filesystem::exists(directory / "c.h5md"));
}

TEST(H5mdRecorder, RecordsAFrameworkWithoutNamesOrBars) {
  const TempDirectory directory;
  const Framework framework = bare(2);
  {
    H5mdRecorder recorder(directory / "run.h5md", framework);
    recorder.record(sample_frame(0, 2).frame);
  }
  const H5mdReader reader(directory / "run.h5md");
  EXPECT_EQ(reader.atoms(), nullptr);
  EXPECT_TRUE(reader.bars().empty());
  EXPECT_EQ(reader.framework().joint_count(), 2u);
}

TEST(H5mdRecorder, EscapesTextThatIsNotUtf8) {
  const TempDirectory directory;
  H5mdHeader header;
  header.parameters = {{"input/file", std::string("latin\xe9")}};
  {
    H5mdRecorder recorder(directory / "run.h5md", chain(2), header);
    recorder.record(sample_frame(0, 2).frame);
  }
  EXPECT_EQ(H5mdReader(directory / "run.h5md").parameters()[0].second,
            Parameter(std::string("latin\\xe9")));
}

TEST(H5mdRecorder, WritesTheSameBytesForTheSameRun) {
  const TempDirectory directory;
  record_file(directory / "a.h5md", 6, 100);
  ::usleep(1'100'000);  // long enough for a time stamp to differ
  record_file(directory / "b.h5md", 6, 100);
  EXPECT_EQ(content_of(directory / "a.h5md"), content_of(directory / "b.h5md"));
}

TEST(H5mdRecorder, RefusesFramesThatMakeNoSense) {
  const TempDirectory directory;
  const std::string path = (directory / "run.h5md").string();
  H5mdRecorder recorder(path, chain(6));
  SampleFrame sample = sample_frame(3, 6);
  recorder.record(sample.frame);
  EXPECT_EQ(message_of<InputError>([&] { recorder.record(sample.frame); }),
            path + ": frame of step 15 comes after that of step 15");
  sample.frame.step = 16;
  sample.positions[4].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of<InputError>([&] { recorder.record(sample.frame); }),
            path + ": frame of step 16: position of A:LYS-3B:CA is not finite");
  sample.frame.positions = sample.frame.positions.first(5);
  EXPECT_EQ(message_of<InputError>([&] { recorder.record(sample.frame); }),
            path + ": frame of step 16 has 5 positions for 6 joints");
  recorder.record(sample_frame(4, 6).frame);
  EXPECT_EQ(recorder.frames(), 2);
  recorder.close();
  EXPECT_EQ(H5mdReader(path).frames(), 2);
}

TEST(H5mdRecorder, RefusesPositionsThatSinglePrecisionCannotHold) {
  const TempDirectory directory;
  H5mdRecorder recorder(directory / "run.h5md", bare(2), {}, {.single = true});
  SampleFrame sample = sample_frame(0, 2);
  sample.positions[1].x = 1e39;
  EXPECT_THAT(message_of<InputError>([&] { recorder.record(sample.frame); }),
              HasSubstr("position of joint 1 is not finite"));
}

TEST(H5mdRecorder, RefusesBadOptionsBeforeItTouchesTheFile) {
  const TempDirectory directory;
  const auto path = directory / "run.h5md";
  const auto message = [&](const H5mdHeader& header, const H5mdOptions& options) {
    return message_of<OptionError>([&] { H5mdRecorder(path, chain(2), header, options); });
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
            "parameter \"topology/x\": the groups framework, limit, sterics, topology and "
            "checkpoint are the "
            "file's own");
  EXPECT_EQ(message(with("x", std::numeric_limits<double>::quiet_NaN()), {}),
            "parameter \"x\": is not a number");
  EXPECT_EQ(message_of<InputError>([&] { H5mdRecorder(path, bare(0)); }),
            "a framework without joints has no trajectory");
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(H5mdRecorder, ReplacesAFileOnlyWhenItMay) {
  const TempDirectory directory;
  const std::string path = (directory / "run.h5md").string();
  std::ofstream(path) << "precious";
  EXPECT_EQ(message_of<FileError>([&] { H5mdRecorder(path, chain(2)); }),
            path + ": exists already, and was not to be overwritten");
  EXPECT_EQ(content_of(path), "precious");
  record_file(path, 4, 2, {.overwrite = true});
  EXPECT_EQ(H5mdReader(path).frames(), 2);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path()), {}), 1);
}

TEST(H5mdRecorder, KeepsTheOldFileWhenTheNewOneFails) {
  const TempDirectory directory;
  const auto path = directory / "run.h5md";
  std::ofstream(path) << "precious";
  H5mdHeader header;
  header.masses = {1.0};
  EXPECT_THROW(H5mdRecorder(path, chain(2), header, {.overwrite = true}), OptionError);
  EXPECT_EQ(content_of(path), "precious");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path()), {}), 1);
}

TEST(H5mdRecorder, TakesItsNameWithItsFirstFrame) {
  const TempDirectory directory;
  const auto path = directory / "run.h5md";
  std::ofstream(path) << "precious";
  {
    H5mdRecorder recorder(path, chain(4), {}, {.overwrite = true, .flush_seconds = 1e9});
    EXPECT_EQ(content_of(path), "precious");
    EXPECT_THROW(recorder.record(sample_frame(0, 3).frame), InputError);
    EXPECT_EQ(content_of(path), "precious");
  }
  EXPECT_EQ(content_of(path), "precious") << "a recorder without frames leaves nothing behind";
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path()), {}), 1);
  H5mdRecorder recorder(path, chain(4), {}, {.overwrite = true, .flush_seconds = 1e9});
  recorder.record(sample_frame(0, 4).frame);
  EXPECT_EQ(H5mdReader(path).frames(), 1);
}

/// A killed writer leaves its temporary file behind.
TEST(H5mdRecorder, TakesOverWhatAKilledWriterLeft) {
  const TempDirectory directory;
  std::ofstream(directory / ".run.h5md.partial") << std::string(100'000, 'x');
  record_file(directory / "run.h5md", 4, 2);
  EXPECT_EQ(H5mdReader(directory / "run.h5md").frames(), 2);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path()), {}), 1);
}

/// A reader asks for the file's length before it reads in the superblock how long it is.
TEST(H5mdRecorder, IsLongerThanTheNextCommitSays) {
  const TempDirectory directory;
  const auto path = directory / "run.h5md";
  H5mdRecorder recorder(path, chain(500), {}, {.flush_seconds = 0.0});
  std::uintmax_t before = 0;
  for (std::int64_t f = 0; f < 200; ++f) {
    recorder.record(sample_frame(f, 500).frame);
    std::ifstream file(path, std::ios::binary);
    std::uint64_t end = 0;  // HDF5 File Format Specification, II.A, version 0: byte 40
    file.seekg(40).read(reinterpret_cast<char*>(&end), sizeof end);
    if (f > 0) {
      EXPECT_GE(before, end) << "frame " << f;
    }
    before = std::filesystem::file_size(path);
  }
  recorder.close();
  std::uint64_t end = 0;
  std::ifstream(path, std::ios::binary).seekg(40).read(reinterpret_cast<char*>(&end), sizeof end);
  EXPECT_EQ(std::filesystem::file_size(path), end);
}

TEST(H5mdRecorder, FollowsASymbolicLink) {
  const TempDirectory directory;
  record_file(directory / "real.h5md", 4, 1);
  std::filesystem::create_symlink("real.h5md", directory / "link.h5md");
  record_file(directory / "link.h5md", 4, 3, {.overwrite = true});
  EXPECT_TRUE(std::filesystem::is_symlink(directory / "link.h5md"));
  EXPECT_EQ(H5mdReader(directory / "real.h5md").frames(), 3);
}

TEST(H5mdRecorder, NamesWhatIsWrongWithThePlace) {
  const TempDirectory directory;
  const auto message = [](const std::filesystem::path& path) {
    return message_of<FileError>([&] { H5mdRecorder(path, chain(2), {}, {.overwrite = true}); });
  };
  const std::string base = directory.path().string();
  EXPECT_EQ(message(directory / "no/run.h5md"),
            base + "/no/run.h5md: the directory " + base + "/no does not exist");
  EXPECT_EQ(message(directory.path()), base + ": is a directory");
  std::ofstream(directory / "file") << "x";
  EXPECT_EQ(message(directory / "file/run.h5md"),
            base + "/file/run.h5md: " + base + "/file is not a directory");
  EXPECT_EQ(message("/dev/full"), "/dev/full: is not a regular file");
  EXPECT_EQ(message(""), "the name of the output file is empty");
}

TEST(H5mdRecorder, SecondRecorderOfAFileIsRefused) {
  const TempDirectory directory;
  const std::string path = (directory / "run.h5md").string();
  H5mdRecorder first(path, chain(4));
  for (const bool overwrite : {false, true}) {
    EXPECT_THAT(
        message_of<FileError>([&] { H5mdRecorder(path, chain(4), {}, {.overwrite = overwrite}); }),
        HasSubstr(path + ": is being written by "));
  }
  record_frames(first, 4, 2);
  first.close();
  EXPECT_EQ(H5mdReader(path).frames(), 2);
  EXPECT_NO_THROW(H5mdRecorder(path, chain(4), {}, {.overwrite = true}));
}

/// A child that records and then waits to be killed; returns when its file is there.
pid_t start_recording_child(const std::string& path) {
  int ready[2];
  if (::pipe(ready) != 0) return -1;
  const pid_t child = ::fork();
  if (child == 0) {
    H5mdRecorder recorder(path, chain(4), {}, {.flush_seconds = 0.0});
    recorder.record(sample_frame(0, 4).frame);
    [[maybe_unused]] const auto told = ::write(ready[1], "x", 1);
    ::pause();
  }
  char byte = 0;
  [[maybe_unused]] const auto heard = ::read(ready[0], &byte, 1);
  ::close(ready[0]), ::close(ready[1]);
  return child;
}

TEST(H5mdRecorder, NamesTheProcessThatWrites) {
  const TempDirectory directory;
  const std::string path = (directory / "run.h5md").string();
  const pid_t child = start_recording_child(path);
  EXPECT_EQ(message_of<FileError>([&] { H5mdRecorder(path, chain(4), {}, {.overwrite = true}); }),
            path + ": is being written by process " + std::to_string(child));
  EXPECT_EQ(H5mdReader(path).frames(), 1) << "a reader is let in";
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(message_of<FileError>([&] { H5mdRecorder(path, chain(4)); }),
            path + ": exists already, and was not to be overwritten");
  EXPECT_NO_THROW(H5mdRecorder(path, chain(4), {}, {.overwrite = true}));
}

TEST(H5mdRecorder, OneOfManyStartedAtOnceWins) {
  const TempDirectory directory;
  for (const bool overwrite : {false, true}) {
    const auto path = directory / (overwrite ? "over.h5md" : "new.h5md");
    std::atomic<int> winners = 0, losers = 0;
    std::vector<std::thread> threads;
    std::vector<std::unique_ptr<H5mdRecorder>> recorders(8);
    for (auto& recorder : recorders)
      threads.emplace_back([&] {
        try {
          recorder = std::make_unique<H5mdRecorder>(path, chain(4), H5mdHeader{},
                                                    H5mdOptions{.overwrite = overwrite});
          ++winners;
        } catch (const FileError&) {
          ++losers;
        }
      });
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(winners, 1);
    EXPECT_EQ(losers, 7);
  }
}

TEST(H5mdRecorder, RecordersOfOneProcessDoNotDisturbEachOther) {
  const TempDirectory directory;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&directory, t] {
      record_file(directory / ("run" + std::to_string(t) + ".h5md"), 10, 200,
                  {.flush_seconds = 0.0});
    });
  for (auto& thread : threads) thread.join();
  for (int t = 0; t < 4; ++t)
    EXPECT_EQ(H5mdReader(directory / ("run" + std::to_string(t) + ".h5md")).frames(), 200);
}

TEST(H5mdRecorder, CommitsInTimeAndOnDemand) {
  const TempDirectory directory;
  H5mdRecorder recorder(directory / "run.h5md", chain(4), {}, {.flush_seconds = 0.02});
  recorder.record(sample_frame(0, 4).frame);
  ::usleep(30'000);
  recorder.record(sample_frame(1, 4).frame);
  EXPECT_EQ(recorder.committed_frames(), 2);
  H5mdRecorder patient(directory / "patient.h5md", chain(4), {}, {.flush_seconds = 1e9});
  patient.record(sample_frame(0, 4).frame);
  EXPECT_EQ(patient.committed_frames(), 1) << "the first at once";
  patient.record(sample_frame(1, 4).frame);
  EXPECT_EQ(patient.committed_frames(), 1);
  patient.flush();
  EXPECT_EQ(patient.committed_frames(), 2);
  EXPECT_EQ(H5mdReader(directory / "patient.h5md").frames(), 2);
}

TEST(H5mdRecorder, MovesAndClosesTwice) {
  const TempDirectory directory;
  H5mdRecorder first(directory / "run.h5md", chain(4));
  first.record(sample_frame(0, 4).frame);
  H5mdRecorder second = std::move(first);
  second.record(sample_frame(1, 4).frame);
  second.close();
  second.close();
  second.flush();
  EXPECT_EQ(second.committed_frames(), 2);
}

}  // namespace h5md_recorder_test
}  // namespace pliant
